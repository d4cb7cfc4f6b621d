#pragma once

#include <vector>

#include "viewer/sim/simulation.h"

namespace kerf::app {

/// A player who needs no hands: swipes across what flies on the stage, again and again. The same simulation and seed
/// give the same swipes. For demonstrations, long runs and pictures; what it does can be saved as a script.
class Autopilot
{
public:
    explicit Autopilot(std::uint64_t seed) : seed_(seed) {}

    /// Input for the coming ticks; call before each advance().
    std::vector<sim::InputEvent> play(const sim::Simulation& simulation);

private:
    std::uint64_t seed_;
    std::uint64_t swipes_ = 0;
    sim::Microseconds busy_until_ = 0;
};

}  // namespace kerf::app
