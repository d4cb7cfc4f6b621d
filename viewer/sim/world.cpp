#include "viewer/sim/world.h"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionDispatcher.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>
#include <BulletDynamics/ConstraintSolver/btSequentialImpulseConstraintSolver.h>
#include <BulletDynamics/Dynamics/btDiscreteDynamicsWorld.h>

#include <algorithm>
#include <cmath>

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

bool is_gone(const Body& body)
{
    const glm::dvec3 c = body.centre(), v = body.motion().velocity;
    const double r = body.radius();
    if (!(std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z))) return true;
    // The farther from the eye, the more of the world is in view.
    const double widening = std::max(1.0, (kEyeDistance - c.z + r) / kEyeDistance);
    if (c.y + r < -kStageHalfHeight * widening && v.y < 0.0) return true;
    return std::abs(c.x) - r > kFarSideways * kStageHalfWidth || std::abs(c.z) > kFarInDepth ||
           c.y > kFarUp * kStageHalfHeight;
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
    for (const auto& body : bodies_) engine_->world.removeRigidBody(&body->rigid_body());
}

void World::step()
{
    for (const auto& body : bodies_) body->remember_pose();
    ++now_;
    engine_->solver.setRandSeed(0);
    engine_->world.stepSimulation(btScalar(kTickSeconds), 0);
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
    std::unique_ptr<Body> body = std::move(*place);
    bodies_.erase(place);
    engine_->world.removeRigidBody(&body->rigid_body());
    return body;
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
    std::vector<std::unique_ptr<Body>> removed;
    for (const ObjectId id : gone) removed.push_back(remove(id));
    return removed;
}

}  // namespace kerf::sim
