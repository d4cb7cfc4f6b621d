#pragma once

#include <cstdint>

namespace kerf::sim {

/// When what a thread makes takes effect in a simulation, whose ticks must not depend on a thread's speed.
enum class Readiness : std::uint8_t
{
    at_once,     ///< in the next tick, which waits for it: without a window
    when_ready,  ///< when the thread is done and all of it is on the graphics card: nothing waits. The simulation gives
                 ///< itself a command then, which is recorded
    on_command,  ///< by that command, which waits: when a recording is played
};

}  // namespace kerf::sim
