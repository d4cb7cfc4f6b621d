#pragma once

#include <optional>
#include <vector>

#include "viewer/game/game_scene.h"
#include "viewer/sim/simulation.h"

namespace kerf::game {

/// A player who needs no hands: swipes across what flies on the stage, again and again. In games it aims at whole
/// fruit, at several in one stroke where it can, and keeps clear of bombs. Where clicks are blows it
/// clicks. The same simulation and seed give the same
/// swipes. For demonstrations, long runs and pictures; what it does can be saved as a script.
class Autopilot
{
public:
    explicit Autopilot(std::uint64_t seed) : seed_(seed) {}

    /// Input for the coming ticks; call before each advance().
    std::vector<sim::InputEvent> play(const sim::Simulation& simulation);

    std::uint64_t swipes() const { return swipes_; }  ///< so far

private:
    std::vector<sim::InputEvent> blow_at_largest(const sim::Simulation& simulation);

    std::uint64_t seed_;
    std::uint64_t swipes_ = 0;
    sim::Microseconds busy_until_ = 0;
};

}  // namespace kerf::game
