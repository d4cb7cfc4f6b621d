#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "viewer/sim/body.h"
#include "viewer/sim/cluster.h"

namespace kerf::sim {

/// m/s^2, downwards.
inline constexpr double kGravity = 9.81;

/// A world holds no more bodies than this: five times what is asked of a frame. A cut through a comb makes thousands of
/// pieces, and the physics of all of them would freeze the program.
inline constexpr std::size_t kMostBodies = 1500;

/// No piece is put where so many bodies' boxes overlap its own. Bullet looks at every pair of boxes that overlap in
/// every tick: pieces in one place, of a soup of triangles or of solids that share a point, would cost their number's
/// square.
inline constexpr std::size_t kMostNeighbours = 64;

/// What a body was dealt by others that it touched in one tick.
struct Impact
{
    ObjectId object = 0, other = 0;
    glm::dvec3 place{0.0};    ///< where they touched, world, metres
    glm::dvec3 impulse{0.0};  ///< on the object, world axes, N s
};

/// What a ray meets first.
struct RayHit
{
    ObjectId object = 0;
    glm::dvec3 place{0.0};  ///< on the object's proxy, world, metres
};

/// All bodies and Bullet's dynamics in ticks of kTickSeconds. Same bodies in the same order: same bits after any number
/// of ticks. Bodies never sleep (nothing here comes to rest) and nothing damps them.
class World
{
public:
    explicit World(double gravity = kGravity);
    ~World();
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    /// Advances by one tick.
    void step();
    Tick now() const { return now_; }
    double gravity() const { return gravity_; }

    Body& add(std::unique_ptr<Body> body);
    /// Takes a body out of the simulation; null when there is none of that id. What it hung on hangs together no longer
    /// where it did by this body alone.
    std::unique_ptr<Body> remove(ObjectId id);
    Body* find(ObjectId id) const;

    /// In the order of their ids.
    std::span<const std::unique_ptr<Body>> bodies() const { return bodies_; }

    /// Lets those of the bodies that bonds hold together move as one from now on; each part moves on as its bodies did as
    /// parts of a rigid whole. The parts, by their first bodies. O(bodies + bonds).
    /// @param bodies  pieces of one object in one pose, in this world, of no cluster; by their ids
    std::vector<std::vector<Body*>> bind(std::span<Body* const> bodies, const std::vector<Bond>& bonds);
    /// The same with the bodies of a cluster, which is gone. @param bonds_left  not those that it holds itself
    std::vector<std::vector<Body*>> part(Cluster& cluster, const std::vector<Bond>& bonds_left);
    /// In the order in which they were bound.
    std::span<const std::unique_ptr<Cluster>> clusters() const { return clusters_; }
    /// Pairs that touched in the last tick.
    std::size_t contacts() const;
    /// What was dealt in the last tick, from `least` N s on, in the order of the objects. Of a cluster any member is the
    /// object. O(pairs).
    std::vector<Impact> impacts(double least) const;
    /// Of the clusters, and what holds them.
    void hash(StateHash& hash) const;
    /// Empty: it meets no proxy. About O(log bodies).
    std::optional<RayHit> first_on_ray(const glm::dvec3& from, const glm::dvec3& to) const;

    /// Removes everything that left the stage for good and returns it: below it and falling, or so far outside that it
    /// can't come back.
    std::vector<std::unique_ptr<Body>> remove_gone();

private:
    struct Engine;
    void unbind(Cluster& cluster);

    std::unique_ptr<Engine> engine_;
    std::vector<std::unique_ptr<Body>> bodies_;
    std::vector<std::unique_ptr<Cluster>> clusters_;  ///< end before their members do
    Tick now_ = 0;
    double gravity_;
};

}  // namespace kerf::sim
