#pragma once

#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/sim/body.h"
#include "viewer/sim/breaking/break_log.h"
#include "viewer/sim/breaking/breaking.h"
#include "viewer/sim/cut_log.h"
#include "viewer/sim/state_hash.h"
#include "viewer/sim/world.h"

namespace kerf::sim {

class Simulation;

/// What happens in the simulation and why: throws, rules, score. A scene uses the simulation's public functions and is
/// told what became of its objects; physics and cutting know nothing of it. Everything that it decides comes from the
/// simulation's seed and its own state, which hash() covers.
class Scene
{
public:
    virtual ~Scene() = default;

    virtual std::string_view name() const = 0;
    /// Of the world that it plays in, m/s^2, downwards.
    virtual double gravity() const { return kGravity; }
    /// How fast its time should run for the player: 1 as on the clock, less for slow motion. Whoever turns frame times
    /// into ticks scales them by it; the simulation itself knows nothing but ticks.
    virtual double time_scale() const { return 1.0; }
    /// Once a tick, after physics and before the blade.
    virtual void tick(Simulation& simulation) = 0;
    virtual void on_cut(Simulation&, const CutRecord&) {}

    /// How the blade breaks an object that it meets; empty: it cuts it.
    virtual std::optional<Breaking> smashes(const Body&) const { return std::nullopt; }
    /// The blade has smashed an object that smashes() said it would; its pieces come later (on_broken()).
    virtual void on_smashed(Simulation&, const Body&, std::uint32_t /*swipe*/) {}
    /// How an object breaks that is whole and was dealt so large an impulse by another one, N s; empty: it does not.
    virtual std::optional<Breaking> crashes(const Body&, double /*impulse*/) const { return std::nullopt; }
    /// The least impulse that clusters and crashes() are told of, N s.
    virtual double least_impact() const { return 1.0; }
    /// Whether presses are blows of the scene's own; then the pointer is no blade.
    virtual bool takes_presses() const { return false; }
    virtual void on_press(Simulation&, const glm::dvec2& /*place*/) {}
    /// An object was taken apart, or could not be.
    virtual void on_broken(Simulation&, const BreakRecord&) {}
    /// Into about how many pieces it breaks an object at most; 0: it breaks none. What that needs to be drawn is made ready.
    virtual std::size_t most_pieces() const { return 0; }

    /// `body` has left the stage and is freed after this call.
    virtual void on_gone(Simulation&, const Body&) {}
    /// A command of the scene's own; false: it has none of that name.
    virtual bool command(Simulation&, std::string_view /*verb*/, std::string_view /*argument*/) { return false; }
    /// Models in the library that will be thrown next, the first of them first, to be made ready meanwhile
    /// (ModelPreparer) and brought onto the graphics card. It says when things may be done and changes nothing of what
    /// happens.
    virtual std::vector<std::size_t> next_models() const { return {}; }
    virtual void hash(StateHash&) const {}
};

/// The scenes of the simulation itself; those of other modules are handed to Simulation. Null for an unknown name.
std::unique_ptr<Scene> make_scene(std::string_view name);
const std::vector<std::string>& scene_names();

}  // namespace kerf::sim
