// Scripts of the viewer: an error of one line that names the line, or events that read back as they were written.

#include <algorithm>
#include <sstream>
#include <string>

#include "common/files/file_error.h"
#include "fuzz/fuzzers.h"
#include "fuzz/require.h"
#include "viewer/sim/script.h"

namespace kerf::core::fuzz {

void fuzz_script(Bytes bytes)
{
    std::istringstream in(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    sim::Script script;
    try {
        script = sim::read_script(in, "a.script");
    } catch (const io::FileError& error) {
        const std::string message = error.what();
        require(message.starts_with("a.script:"), "an error names its file and line");
        require(message.size() < 300, "an error is a sentence, not a copy of the file");
        require(std::none_of(message.begin(), message.end(), [](unsigned char c) { return c < ' ' || c == 0x7F; }),
                "an error has no control characters");
        return;
    }
    std::stringstream copy;
    sim::write_script(copy, script);
    require(sim::read_script(copy, "copy") == script, "a script reads back as it was written");
}

}  // namespace kerf::core::fuzz
