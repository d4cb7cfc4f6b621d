#include "viewer/app/headless/run_length.h"

namespace kerf::app {

std::int64_t frames_of(const Options& options, const sim::Script& script)
{
    if (options.frames > 0) return options.frames;
    const sim::Microseconds end = script.events.empty() ? 0 : script.events.back().time;
    return sim::tick_of(end + 1'000'000) / sim::kTicksPerFrame;
}

}  // namespace kerf::app
