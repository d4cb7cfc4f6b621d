#pragma once

#include <memory>
#include <span>
#include <vector>

#include "viewer/sim/body.h"

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
    /// Takes a body out of the simulation; null when there is none of that id.
    std::unique_ptr<Body> remove(ObjectId id);
    Body* find(ObjectId id) const;

    /// In the order of their ids.
    std::span<const std::unique_ptr<Body>> bodies() const { return bodies_; }
    /// Pairs that touched in the last tick.
    std::size_t contacts() const;

    /// Removes everything that left the stage for good and returns it: below it and falling, or so far outside that it
    /// can't come back.
    std::vector<std::unique_ptr<Body>> remove_gone();

private:
    struct Engine;
    std::unique_ptr<Engine> engine_;
    std::vector<std::unique_ptr<Body>> bodies_;
    Tick now_ = 0;
    double gravity_;
};

}  // namespace kerf::sim
