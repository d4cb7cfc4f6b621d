#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/sim/blade.h"
#include "viewer/sim/breaking/breaker.h"
#include "viewer/sim/camera.h"
#include "viewer/sim/cut_log.h"
#include "viewer/sim/cutting_plane.h"
#include "viewer/sim/input_queue.h"
#include "viewer/sim/model_library.h"
#include "viewer/sim/readiness.h"
#include "viewer/sim/scene.h"
#include "viewer/sim/script.h"
#include "viewer/sim/thrower.h"
#include "viewer/sim/world.h"

namespace kerf::sim {

/// What a simulation is started with.
struct Settings
{
    std::string scene = "report";
    std::string backend;  ///< of the first throw; empty: the default (back_ends.h)
    ProxyKind proxy = ProxyKind::bounded_hull;
    Gesture gesture = Gesture::blade;
    std::uint64_t seed = 1;
    bool hash_surfaces = false;  ///< fill in surface hashes, measure caps: O(n) for each cut, off the timed path
    bool record = false;         ///< keep what is pushed, for recording()
    Readiness breaks = Readiness::at_once;  ///< when the pieces of what is broken are there
};

/// A piece that is ready and not yet a body: it is brought onto the graphics card meanwhile.
struct WaitingPiece
{
    Object* object = nullptr;
    std::uint64_t key = 0;  ///< BrokenPiece::key
    ObjectId parent = 0;    ///< what it is a piece of
};

/// A run: world, blade and scene in one, in ticks. It does not know of time on the wall, windows or graphics; the same
/// settings and the same events give the same state, bit for bit, however the events were grouped into frames.
///
/// A tick is: physics; objects that left are freed; the scene; the input whose time has come, in order, each segment of
/// the blade against every object at once.
///
/// Commands (InputKind::command; command() now): `backend NAME`, `proxy KIND`, `gesture NAME` for what is thrown from
/// now on, `break ID` (Readiness), and those of the scene.
class Simulation
{
public:
    /// @param scene  what is played, for Settings::scene; null: what make_scene() gives for that, which needs a model
    /// @throws std::invalid_argument  one sentence: unknown scene or back end, no models
    Simulation(std::shared_ptr<ModelLibrary> models, Settings settings, std::unique_ptr<Scene> scene = nullptr);
    ~Simulation();

    Tick now() const { return world_.now(); }
    Microseconds time() const { return time_of(now()); }
    const Settings& settings() const { return settings_; }

    /// Input for a later tick. What is earlier than the present counts for the next tick. Events of equal time keep
    /// their order.
    void push(InputEvent event);
    void push(const std::vector<InputEvent>& events);

    void advance(Tick ticks = 1);

    /// Carries out a command in the next tick, and records it.
    void command(const std::string& text);
    /// Why the last command or throw failed; empty when it did not. One sentence. Cleared by reading.
    std::string take_message();

    const World& world() const { return world_; }
    std::span<const std::unique_ptr<Body>> bodies() const { return world_.bodies(); }
    const Blade& blade() const { return blade_; }
    const Scene& scene() const { return *scene_; }
    ModelLibrary& models() const { return *models_; }
    const std::string& backend() const { return backend_; }
    ProxyKind proxy() const { return proxy_; }

    /// What the next tick starts with: the last of the commands that wait for it, or what is so already. A paused
    /// simulation has taken in none of them.
    std::string backend_to_come() const;
    ProxyKind proxy_to_come() const;
    Gesture gesture_to_come() const;

    /// All cuts since the start, oldest first.
    const std::vector<CutRecord>& cuts() const { return cuts_; }
    /// All objects that were taken apart since the start, and all that blows broke of bonds, oldest first.
    const std::vector<BreakRecord>& breaks() const { return breaks_; }
    const std::vector<CrackRecord>& cracks() const { return cracks_; }
    /// Whether it was struck and is being taken apart: nothing can be done to it meanwhile.
    bool is_breaking(ObjectId id) const;
    /// Pieces that are ready and not yet in the world.
    std::vector<WaitingPiece> waiting_pieces() const;
    /// What Settings::hash_surfaces has cost since the start, time of this thread on a processor: no part of a game.
    double check_cpu_ms() const { return check_cpu_ms_; }
    /// Whether any two bodies have touched since the start.

    /// Hash of the whole state: bodies bit for bit, ids, input not yet taken in, the scene.
    std::uint64_t state_hash() const;

    /// What was pushed so far as a script that repeats the run (with Settings::record).
    Script recording() const;

    // For scenes.

    /// Throws a model along the flight of `what.seed`. Null when it can't be prepared or there is no room
    /// (take_message() says why).
    const Body* throw_object(const Throw& what);
    /// Puts an object into the world as it is said.
    const Body* place_object(std::size_t model, double scale, const glm::dvec3& centre, const glm::dmat3& rotation,
                             const Motion& motion);
    /// The same for one that comes from outside: Body::is_entering().
    const Body* let_enter(std::size_t model, double scale, const glm::dvec3& centre, const glm::dmat3& rotation,
                          const Motion& motion);
    /// Makes an object move otherwise from now on. False: there is none of that id.
    bool move_object(ObjectId id, const Motion& motion);
    /// Strikes an object. One that is whole is taken apart on a thread, and drawn whole until its pieces are there
    /// (Settings::breaks); of a cluster bonds break at once.
    void strike(ObjectId id, const Blow& blow, const Breaking& how, std::uint32_t swipe = 0);
    /// Pushes an object, as a blow does that breaks nothing.
    void push_object(ObjectId id, const Blow& blow);
    /// The last throw; empty before the first.
    std::optional<Throw> last_throw() const { return last_throw_; }
    /// A number for the n-th decision of a scene.
    std::uint64_t seed_for(std::uint64_t n) const;
    void report(std::string message) { message_ = std::move(message); }

private:
    void take_input();
    void carry_out(const InputEvent& event);
    void apply_command(const std::string& text);
    std::string_view waiting_argument(std::string_view verb) const;
    void swing(const BladeSegment& segment);
    void cut(Body& body, const WorldPlane& plane, std::uint32_t swipe);
    void smash(Body& body, const BladeSegment& segment, const WorldPlane& plane, const Breaking& how);
    void crack(Cluster& cluster, const Blow& blow, double speed);
    void take_impacts();
    void settle_breaks();
    void finish_break(ObjectId id);

    /// An object that is being taken apart.
    struct PendingBreak
    {
        ObjectId object = 0;
        Tick struck = 0;
        Breaking how;
        glm::dvec3 impulse{0.0};
        bool pushes = true;
        std::uint32_t swipe = 0;
        std::shared_ptr<BreakJob> job;
        bool is_announced = false;  ///< the command that finishes it is on its way
    };

    std::shared_ptr<ModelLibrary> models_;
    Settings settings_;
    std::unique_ptr<Scene> scene_;
    World world_;
    Blade blade_;
    std::string backend_;
    ProxyKind proxy_;
    InputQueue input_;
    std::vector<CutRecord> cuts_;
    std::vector<BreakRecord> breaks_;
    std::vector<CrackRecord> cracks_;
    std::vector<PendingBreak> pending_;  ///< in the order of the blows
    std::uint64_t partings_ = 0;         ///< breaks and cracks so far
    Breaker breaker_;
    std::optional<Throw> last_throw_;
    std::string message_;
    ObjectId last_id_ = 0;
    std::uint64_t throws_ = 0;
    double check_cpu_ms_ = 0.0;
    bool had_contact_ = false;
};

}  // namespace kerf::sim
