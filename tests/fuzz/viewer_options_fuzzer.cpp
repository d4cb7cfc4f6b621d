// The command line of kerf-viewer: options within their limits, or a reason and an exit status.

#include <cmath>

#include "fuzz/command_line.h"
#include "fuzz/fuzzers.h"
#include "fuzz/require.h"
#include "viewer/app/exit_status.h"
#include "viewer/app/options.h"

namespace kerf::core::fuzz {

void fuzz_viewer_options(Bytes bytes)
{
    CommandLine line("kerf-viewer", bytes);
    const Silence silence;
    const app::ParsedOptions parsed = app::parse_options(line.argc(), line.argv());
    if (!parsed.options) {
        require(!silence.text().empty(), "a command line that is not run has an answer");
        require(parsed.exit_status == 0 || parsed.exit_status == app::kWrongUse, "its exit status is one of two");
        return;
    }
    const app::Options& options = *parsed.options;
    require(options.width >= 1 && options.height >= 1, "pictures have a size");
    require(options.frames >= 0 && options.draw_every >= 0, "frames are counted from 0");
    require(options.view.zoom >= 1.0f && options.view.zoom <= 100.0f, "the picture is enlarged within limits");
    require(std::isfinite(options.view.zoom_at.x) && std::isfinite(options.view.zoom_at.y),
            "the place to enlarge is a place");
}

}  // namespace kerf::core::fuzz
