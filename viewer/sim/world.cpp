#include "viewer/sim/world.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <utility>

#include "viewer/sim/bullet_glm.h"
#include "viewer/sim/camera.h"

namespace kerf::sim {
namespace {

/// Farther than so many half stages to a side, or so far towards or away from the eye, nothing comes back. Metres for
/// the depth: less than the eye's distance, so that nothing flies through the eye.
constexpr double kFarSideways = 2.5;
constexpr double kFarInDepth = 8.0;
/// Higher than this, in half stages, is out of reach as well: 40 m, after a collision gone wrong.
constexpr double kFarUp = 10.0;

/// Siblings, and what is still on its way to the stage, are not handed to the narrow phase.
class SelectiveDispatcher : public btCollisionDispatcher
{
public:
    SelectiveDispatcher(btCollisionConfiguration* configuration, const Tick& now)
        : btCollisionDispatcher(configuration), now_(now)
    {
    }

    bool needsCollision(const btCollisionObject* a, const btCollisionObject* b) override
    {
        const auto* first = static_cast<const Body*>(a->getUserPointer());
        const auto* second = static_cast<const Body*>(b->getUserPointer());
        return !first->is_entering() && !second->is_entering() && !Body::are_siblings(*first, *second, now_) &&
               btCollisionDispatcher::needsCollision(a, b);
    }

private:
    const Tick& now_;
};

/// Bullet widens every box by so much before it looks for pairs, metres; it is one number for the whole process. Its
/// default, 5 cm, spares work for what hardly moves. Pieces fly, and those of a cut asteroid are a few times as large:
/// width only makes pairs of neighbours that don't touch.
constexpr btScalar kBroadphaseMargin = 0.005f;

void tighten_broadphase()
{
    static const bool once = [] {
        gDbvtMargin = kBroadphaseMargin;
        return true;
    }();
    static_cast<void>(once);
}

bool is_gone(const glm::dvec3& c, const glm::dvec3& v, double r)
{
    if (!(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z))) return true;
    // The farther from the eye, the more of the world is in view.
    const double widening = std::max(1.0, (kEyeDistance - c.z + r) / kEyeDistance);
    if (c.y + r < -kStageHalfHeight * widening && v.y < 0.0) return true;
    return std::abs(c.x) - r > kFarSideways * kStageHalfWidth || std::abs(c.z) > kFarInDepth ||
           c.y > kFarUp * kStageHalfHeight;
}

/// A part of something is gone when all of it is.
bool is_gone(const Body& body)
{
    if (const Cluster* const whole = body.cluster())
        return is_gone(whole->centre(), whole->motion().velocity, whole->radius());
    return is_gone(body.centre(), body.motion().velocity, body.radius());
}

/// Of bodies that move as a rigid whole: that of their common centre.
Motion common_motion(const std::vector<Body*>& bodies)
{
    double mass = 0.0;
    glm::dvec3 centre(0.0);
    for (const Body* const body : bodies) {
        mass += body->mass();
        centre += body->mass() * body->centre();
    }
    centre /= mass;
    const Body& first = *bodies.front();
    const Motion motion = first.motion();
    return {motion.velocity + glm::cross(motion.spin, centre - first.centre()), motion.spin};
}

/// What bonds hold together, by the first of each.
std::vector<std::vector<Body*>> parts_of(std::span<Body* const> members, const std::vector<Bond>& bonds)
{
    std::map<ObjectId, std::size_t> place;
    for (std::size_t i = 0; i < members.size(); ++i) place[members[i]->id()] = i;
    std::vector<std::size_t> root(members.size());
    for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
    const auto find = [&](std::size_t i) {
        while (root[i] != i) i = root[i] = root[root[i]];
        return i;
    };
    for (const Bond& bond : bonds) {
        const auto first = place.find(bond.first), second = place.find(bond.second);
        if (first == place.end() || second == place.end()) continue;
        const std::size_t a = find(first->second), b = find(second->second);
        root[std::max(a, b)] = std::min(a, b);
    }
    std::vector<std::vector<Body*>> parts;
    std::map<std::size_t, std::size_t> part_of;
    for (std::size_t i = 0; i < members.size(); ++i) {
        const auto [found, is_new] = part_of.try_emplace(find(i), parts.size());
        if (is_new) parts.emplace_back();
        parts[found->second].push_back(members[i]);
    }
    return parts;
}

/// All of it is where the stage is seen, at the depth of the stage.
bool is_on_stage(const Body& body)
{
    const glm::dvec3 c = body.centre();
    const double r = body.radius();
    return std::abs(c.x) + r <= kStageHalfWidth && std::abs(c.y) + r <= kStageHalfHeight;
}

}  // namespace

struct World::Engine
{
    Engine(const Tick& now, double gravity)
        : dispatcher(&configuration, now), world(&dispatcher, &broadphase, &solver, &configuration)
    {
        tighten_broadphase();
        world.setGravity(btVector3(0.0f, btScalar(-gravity), 0.0f));
        // Contacts in an order that depends on who touches whom and not on the history of a hash table.
        world.getDispatchInfo().m_deterministicOverlappingPairs = true;
        // Overlaps are pushed apart without adding velocity: pieces begin to collide while they may still overlap.
        world.getSolverInfo().m_splitImpulse = 1;
        world.getSolverInfo().m_splitImpulsePenetrationThreshold = 0.0f;
    }

    btDefaultCollisionConfiguration configuration;
    SelectiveDispatcher dispatcher;
    btDbvtBroadphase broadphase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world;
};

World::World(double gravity) : engine_(std::make_unique<Engine>(now_, gravity)), gravity_(gravity) {}

World::~World()
{
    for (const auto& cluster : clusters_) engine_->world.removeRigidBody(&cluster->rigid_body());
    for (const auto& body : bodies_)
        if (body->cluster() == nullptr) engine_->world.removeRigidBody(&body->rigid_body());
}

void World::step()
{
    for (const auto& body : bodies_) body->remember_pose();
    for (const auto& cluster : clusters_) cluster->remember_pose();
    ++now_;
    engine_->solver.setRandSeed(0);
    engine_->world.stepSimulation(btScalar(kTickSeconds), 0);
    for (const auto& cluster : clusters_) cluster->carry();
    for (const auto& body : bodies_)
        if (body->is_entering() && is_on_stage(*body)) body->set_entering(false);
}

Body& World::add(std::unique_ptr<Body> body)
{
    engine_->world.addRigidBody(&body->rigid_body());
    const auto place = std::upper_bound(bodies_.begin(), bodies_.end(), body->id(),
                                        [](ObjectId id, const auto& other) { return id < other->id(); });
    return **bodies_.insert(place, std::move(body));
}

std::unique_ptr<Body> World::remove(ObjectId id)
{
    const auto place = std::find_if(bodies_.begin(), bodies_.end(), [&](const auto& b) { return b->id() == id; });
    if (place == bodies_.end()) return nullptr;
    if (Cluster* const cluster = (*place)->cluster()) {
        std::vector<Bond> left(cluster->bonds().begin(), cluster->bonds().end());
        std::erase_if(left, [id](const Bond& bond) { return bond.first == id || bond.second == id; });
        part(*cluster, left);
    }
    std::unique_ptr<Body> body = std::move(*place);
    bodies_.erase(place);
    engine_->world.removeRigidBody(&body->rigid_body());
    return body;
}

std::vector<std::vector<Body*>> World::bind(std::span<Body* const> bodies, const std::vector<Bond>& bonds)
{
    std::vector<std::vector<Body*>> parts = parts_of(bodies, bonds);
    for (const std::vector<Body*>& members : parts) {
        if (members.size() == 1) continue;
        std::set<ObjectId> ids;
        for (const Body* const body : members) {
            ids.insert(body->id());
            engine_->world.removeRigidBody(&body->rigid_body());
        }
        std::vector<Bond> within;
        for (const Bond& bond : bonds)
            if (ids.contains(bond.first) && ids.contains(bond.second)) within.push_back(bond);
        clusters_.push_back(std::make_unique<Cluster>(members, std::move(within), common_motion(members)));
        engine_->world.addRigidBody(&clusters_.back()->rigid_body());
    }
    return parts;
}

void World::unbind(Cluster& cluster)
{
    engine_->world.removeRigidBody(&cluster.rigid_body());
    const std::vector<Body*> members(cluster.members().begin(), cluster.members().end());
    std::erase_if(clusters_, [&](const auto& one) { return one.get() == &cluster; });
    for (const Body* const body : members) engine_->world.addRigidBody(&body->rigid_body());
}

std::vector<std::vector<Body*>> World::part(Cluster& cluster, const std::vector<Bond>& bonds_left)
{
    const std::vector<Body*> members(cluster.members().begin(), cluster.members().end());
    unbind(cluster);
    return bind(members, bonds_left);
}

std::vector<Impact> World::impacts(double least) const
{
    // A cluster has a manifold for each member that touches: they are one impact.
    struct Dealt
    {
        glm::dvec3 impulse{0.0}, place{0.0};
        double whole = 0.0;  ///< sum of the impulses' sizes: the weight of `place`
    };
    std::map<std::pair<ObjectId, ObjectId>, Dealt> pairs;
    for (int i = 0; i < engine_->dispatcher.getNumManifolds(); ++i) {
        const btPersistentManifold& manifold = *engine_->dispatcher.getManifoldByIndexInternal(i);
        ObjectId first = static_cast<const Body*>(manifold.getBody0()->getUserPointer())->id();
        ObjectId second = static_cast<const Body*>(manifold.getBody1()->getUserPointer())->id();
        const double sign = first < second ? 1.0 : -1.0;
        if (first > second) std::swap(first, second);
        for (int c = 0; c < manifold.getNumContacts(); ++c) {
            const btManifoldPoint& point = manifold.getContactPoint(c);
            const auto size = double(point.getAppliedImpulse());
            if (!(size > 0.0)) continue;
            Dealt& dealt = pairs[{first, second}];
            dealt.impulse += sign * size * to_glm(point.m_normalWorldOnB);
            dealt.place += size * to_glm(point.getPositionWorldOnB());
            dealt.whole += size;
        }
    }
    std::vector<Impact> all;
    for (const auto& [pair, dealt] : pairs) {
        if (!(glm::length(dealt.impulse) >= least)) continue;
        const glm::dvec3 place = dealt.place / dealt.whole;
        all.push_back({pair.first, pair.second, place, dealt.impulse});
        all.push_back({pair.second, pair.first, place, -dealt.impulse});
    }
    std::sort(all.begin(), all.end(), [](const Impact& a, const Impact& b) {
        return std::pair(a.object, a.other) < std::pair(b.object, b.other);
    });
    return all;
}

std::optional<RayHit> World::first_on_ray(const glm::dvec3& from, const glm::dvec3& to) const
{
    /// Remembers which child of a compound it was.
    struct Closest : btCollisionWorld::ClosestRayResultCallback
    {
        using ClosestRayResultCallback::ClosestRayResultCallback;
        btScalar addSingleResult(btCollisionWorld::LocalRayResult& result, bool in_world) override
        {
            child = result.m_localShapeInfo != nullptr ? result.m_localShapeInfo->m_triangleIndex : 0;
            return ClosestRayResultCallback::addSingleResult(result, in_world);
        }
        int child = 0;
    };
    Closest closest(to_bullet(from), to_bullet(to));
    engine_->world.rayTest(to_bullet(from), to_bullet(to), closest);
    if (!closest.hasHit()) return std::nullopt;
    const auto* body = static_cast<const Body*>(closest.m_collisionObject->getUserPointer());
    if (const Cluster* const cluster = body->cluster()) body = cluster->members()[std::size_t(closest.child)];
    return RayHit{body->id(), to_glm(closest.m_hitPointWorld)};
}

void World::hash(StateHash& hash) const
{
    for (const auto& cluster : clusters_) cluster->hash(hash);
}

Body* World::find(ObjectId id) const
{
    const auto place = std::lower_bound(bodies_.begin(), bodies_.end(), id,
                                        [](const auto& body, ObjectId wanted) { return body->id() < wanted; });
    return place != bodies_.end() && (*place)->id() == id ? place->get() : nullptr;
}

std::size_t World::contacts() const
{
    std::size_t touching = 0;
    for (int i = 0; i < engine_->dispatcher.getNumManifolds(); ++i)
        if (engine_->dispatcher.getManifoldByIndexInternal(i)->getNumContacts() > 0) ++touching;
    return touching;
}

std::vector<std::unique_ptr<Body>> World::remove_gone()
{
    std::vector<ObjectId> gone;
    for (const auto& body : bodies_)
        if (is_gone(*body)) gone.push_back(body->id());
    // A cluster goes as a whole: it is not bound anew for each member that is taken out.
    for (const ObjectId id : gone)
        if (Cluster* const cluster = find(id)->cluster()) unbind(*cluster);
    std::vector<std::unique_ptr<Body>> removed;
    for (const ObjectId id : gone) removed.push_back(remove(id));
    return removed;
}

}  // namespace kerf::sim
