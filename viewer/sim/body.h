#pragma once

#include <kerf/object.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "viewer/sim/body_proxies.h"
#include "viewer/sim/pose.h"
#include "viewer/sim/proxy_shape.h"
#include "viewer/sim/solid.h"
#include "viewer/sim/state_hash.h"
#include "viewer/sim/ticks.h"

class btRigidBody;

namespace kerf::sim {

class Cluster;

/// Counts up from 1 in the order in which objects appear; the same script gives the same ids.
using ObjectId = std::uint64_t;

/// Pieces of one cut lie against each other and are left alone by the collision engine until they had time to part.
inline constexpr Tick kSiblingTicks = 12;  // 100 ms

/// A cut that a body descends from, remembered as long as siblings ignore one another.
struct RecentCut
{
    std::uint64_t cut = 0;  ///< serial number of the cut
    Tick until = 0;         ///< first tick in which its pieces collide
};

/// What stays the same from a thrown object to its last splinter.
struct Origin
{
    std::uint64_t throw_number = 0;  ///< counts up from 1: shared buffers never outlive it
    std::size_t model = 0;           ///< index into the ModelLibrary
    std::uint64_t copy = 0;          ///< which of the library's copies (Throwable::copy)
    std::string backend;             ///< that prepared it, and cuts it
    double scale = 1.0;              ///< metres a mesh unit
    glm::dvec3 centre{0.0};          ///< centre of the thrown mesh's box, mesh coordinates
    double radius = 1.0;             ///< half of that box's diagonal, mesh units
};

/// Who a body is.
struct Identity
{
    ObjectId id = 0;
    ObjectId parent = 0;  ///< the object that it was cut from; 0: thrown whole
    Origin origin;
    Tick birth = 0;
    std::uint32_t last_swipe = 0;        ///< the swipe that cut it last, or cut what it came from; 0: none
    std::vector<RecentCut> recent_cuts;  ///< that have not run out at birth
    bool closed_rightly = true;          ///< CutRecord::closed_rightly of all cuts that it descends from
};

/// A piece of a body: of the same origin, and a sibling of the other pieces of this cut and of those that have not run out.
/// @param swipe  that made it, and does not cut it again
Identity heir_of(const Identity& parent, ObjectId id, Tick birth, std::uint32_t swipe, const RecentCut& cut);

/// One flying piece: something to cut, and the rigid body that carries it. The body's origin is the centre of mass and
/// its axes are the principal ones, so Bullet's diagonal inertia is exact; mesh coordinates never change.
class Body
{
public:
    /// @param object  must not be empty
    /// @param solid   solid_of() the object
    /// @param pose    where its mesh stands; pose.scale is identity.origin.scale
    /// Builds the collision proxy (timed: proxy_ms()).
    Body(Identity identity, Object object, const Solid& solid, const MeshPose& pose, const Motion& motion,
         ProxyKind proxy);
    /// The same with a proxy that was built before: of this object or one that it is a copy of.
    Body(Identity identity, Object object, const Solid& solid, const MeshPose& pose, const Motion& motion,
         CollisionProxy proxy);
    ~Body();
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;

    const Identity& identity() const { return identity_; }
    ObjectId id() const { return identity_.id; }
    /// A swipe that met the proxy but not the solid is logged once.
    std::uint32_t missed_swipe() const { return missed_swipe_; }
    void mark_missed(std::uint32_t swipe) { missed_swipe_ = swipe; }

    Object& object() { return object_; }
    const Object& object() const { return object_; }
    /// Takes the object out to be cut; put_back() when it was not.
    Object take_object() { return std::move(object_); }
    void put_back(Object object) { object_ = std::move(object); }

    const Solid& solid() const { return solid_; }
    double mass() const { return solid_.mass; }
    const ProxyShape& proxy() const { return *proxy_; }
    double proxy_ms() const { return proxy_ms_; }

    /// Where the mesh stands now.
    MeshPose pose() const;
    /// The same between the last tick (0) and now (1), for drawing between ticks.
    MeshPose pose_at(double fraction) const;
    /// Model matrix for drawing: mesh coordinates to world.
    glm::dmat4 model_matrix(double fraction = 1.0) const { return pose_at(fraction).matrix(); }

    glm::dvec3 centre() const;  ///< of mass, in the world, metres
    Motion motion() const;
    void set_motion(const Motion& motion);
    /// Deals it an impulse at a place of the world, N s.
    void push(const glm::dvec3& place, const glm::dvec3& impulse);
    /// Inertia tensor about the centre in world axes, kg m^2.
    glm::dmat3 world_inertia() const;
    /// About a point of the world: spin and orbit together, kg m^2/s.
    glm::dvec3 angular_momentum(const glm::dvec3& about) const;
    glm::dvec3 momentum() const { return solid_.mass * motion().velocity; }
    double radius() const { return proxy_->radius(); }

    /// On its way to the stage: touches nothing until all of it is there (World::step()), so that nobody is knocked
    /// away unseen.
    bool is_entering() const { return is_entering_; }
    void set_entering(bool entering) { is_entering_ = entering; }

    /// What it is a part of, and moves with; null: it moves by itself. The world's business (World::bind()).
    Cluster* cluster() const { return cluster_; }
    void set_cluster(Cluster* cluster) { cluster_ = cluster; }
    /// Moves it as a part of what has this pose, and this motion about `centre`.
    void be_carried(const MeshPose& pose, const glm::dvec3& centre, const Motion& motion);

    /// From now on a sibling of all pieces of that cut. Forgets those that have run out.
    void add_recent_cut(const RecentCut& cut, Tick now);
    /// True when both come from one cut that is younger than kSiblingTicks.
    static bool are_siblings(const Body& a, const Body& b, Tick now);

    /// Everything that the body's future depends on, bit for bit.
    void hash(StateHash& hash) const;

    btRigidBody& rigid_body() const { return *rigid_; }
    /// Remembers the present pose as that of the last tick: World calls it before each step.
    void remember_pose();

private:
    /// Makes the rigid body that stands for the proxy.
    void embody(CollisionProxy proxy, const MeshPose& pose, const Motion& motion);
    MeshPose mesh_pose(const glm::dvec3& centre, const glm::dmat3& rotation) const;

    Identity identity_;
    Object object_;
    Solid solid_;
    double proxy_ms_ = 0.0;
    std::unique_ptr<ProxyShape> proxy_;
    std::unique_ptr<btRigidBody> rigid_;
    std::uint32_t missed_swipe_ = 0;
    bool is_entering_ = false;
    Cluster* cluster_ = nullptr;
    glm::dvec3 last_centre_{0.0};
    glm::dmat3 last_rotation_{1.0};
};

}  // namespace kerf::sim
