#pragma once

#include <cstdint>

// Time in the simulation. Physics advances in ticks of 1/120 s and nothing else; input carries its time in whole
// microseconds, so that no answer depends on how floating point seconds were added up.

namespace kerf::sim {

/// Physics steps in a second: two for each frame of a 60 Hz display, and fast enough that a piece at 10 m/s moves 8 cm.
inline constexpr std::int64_t kTicksPerSecond = 120;
inline constexpr double kTickSeconds = 1.0 / double(kTicksPerSecond);

/// Frames of a run without a screen: two ticks each.
inline constexpr std::int64_t kTicksPerFrame = 2;

using Tick = std::int64_t;
using Microseconds = std::int64_t;

/// The first tick at or after `time`: the one that takes in input of that time.
constexpr Tick tick_of(Microseconds time)
{
    const std::int64_t scaled = time * kTicksPerSecond;
    return scaled <= 0 ? 0 : (scaled + 999'999) / 1'000'000;
}

/// When a tick happens, rounded down: tick_of(time_of(n)) == n.
constexpr Microseconds time_of(Tick tick)
{
    return tick * 1'000'000 / kTicksPerSecond;
}

}  // namespace kerf::sim
