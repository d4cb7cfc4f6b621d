#pragma once

#include <string>
#include <vector>

#include "viewer/effects/bursts.h"
#include "viewer/effects/drops.h"
#include "viewer/effects/popups.h"
#include "viewer/effects/shake.h"
#include "viewer/effects/stains.h"
#include "viewer/game/game_scene.h"
#include "viewer/sim/simulation.h"

namespace kerf::effects {

/// Everything that is seen of a run and means nothing. It watches a simulation, which does not know of it; the same run
/// gives the same effects.
class Effects
{
public:
    /// Takes in what happened since the last call, and lets its own things move on to the simulation's present. Call it
    /// after each batch of ticks. O(drops + stains + points of new sections, of which few are looked at)
    void follow(const sim::Simulation& simulation);

    const Drops& drops() const { return drops_; }
    const Stains& stains() const { return stains_; }
    const Popups& popups() const { return popups_; }
    const Shake& shake() const { return shake_; }
    float flash() const { return flash_; }  ///< how white the picture is, 0 to 1

    /// How much slower than usual time should pass for the player just now, 0 to 1: for the feel of a good hit. Whoever
    /// turns frame times into ticks asks for it; nothing else changes.
    double time_scale() const;

private:
    void take_cut(const sim::Simulation& simulation, const sim::CutRecord& cut);
    void take_break(const sim::Simulation& simulation, const sim::BreakRecord& broken);
    void take_crack(const sim::Simulation& simulation, const sim::CrackRecord& crack);
    void take_event(const game::GameEvent& event, std::int64_t lives_at_start);
    void step(const sim::Simulation& simulation);
    void say(const glm::dvec2& place, std::string text, const glm::vec3& colour, float size, float life = 1.1f);

    Drops drops_;
    Stains stains_;
    Popups popups_;
    Shake shake_;
    float flash_ = 0.0f;
    float slowed_ = 0.0f;  ///< seconds of simulation time for which it stays slow
    std::size_t cuts_seen_ = 0, breaks_seen_ = 0, cracks_seen_ = 0, events_seen_ = 0;
    sim::Tick now_ = 0;
    std::vector<WallHit> hits_;
};

}  // namespace kerf::effects
