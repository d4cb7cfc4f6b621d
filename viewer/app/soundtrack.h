#pragma once

#include <cstddef>

#include "viewer/sim/simulation.h"
#include "viewer/sound/speaker.h"

namespace kerf::app {

/// Makes sounds of what happens in a simulation, which does not know of it.
class Soundtrack
{
public:
    /// Plays what happened since the last call. Call it after each batch of ticks.
    void follow(const sim::Simulation& simulation, sound::Speaker& speaker);

private:
    void follow_breaks(const sim::Simulation& simulation, sound::Speaker& speaker);
    void follow_blade(const sim::Simulation& simulation, sound::Speaker& speaker);
    void follow_game(const sim::Simulation& simulation, sound::Speaker& speaker);

    std::size_t cuts_seen_ = 0, breaks_seen_ = 0, cracks_seen_ = 0, events_seen_ = 0;
    sim::Tick last_swish_ = -sim::kTicksPerSecond;
    int seconds_told_ = 0;
};

}  // namespace kerf::app
