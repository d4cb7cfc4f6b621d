#include "viewer/sim/rigid_body.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "viewer/sim/bullet_glm.h"

namespace kerf::sim {
namespace {

/// What the solver is told at least, kg and kg m^2: the inverse of a splinter's mass must stay a sensible float beside
/// that of a whole object. Only contacts see it; velocities and momentum go by the real mass.
constexpr double kLightestForSolver = 1e-3;
constexpr double kLeastMomentForSolver = 1e-7;

/// Bounce and friction of contacts: wood on wood.
constexpr btScalar kRestitution = 0.3f, kFriction = 0.5f;

}  // namespace

std::unique_ptr<btRigidBody> make_rigid_body(const Inertia& inertia, btCollisionShape& shape, const btTransform& place)
{
    const glm::dvec3 moments = glm::max(inertia.moments, glm::dvec3(kLeastMomentForSolver));
    btRigidBody::btRigidBodyConstructionInfo info(btScalar(std::max(inertia.mass, kLightestForSolver)), nullptr, &shape,
                                                  to_bullet(moments));
    info.m_startWorldTransform = place;
    info.m_restitution = kRestitution;
    info.m_friction = kFriction;
    auto body = std::make_unique<btRigidBody>(info);
    body->setActivationState(DISABLE_DEACTIVATION);
    return body;
}

void push(btRigidBody& body, const glm::dvec3& place, const glm::dvec3& impulse)
{
    const glm::dvec3 arm = place - to_glm(body.getCenterOfMassPosition());
    glm::dvec3 spin = to_glm(body.getInvInertiaTensorWorld() * to_bullet(glm::cross(arm, impulse)));
    if (const double speed = glm::length(spin); speed > kFastestSpinOfBlow) spin *= kFastestSpinOfBlow / speed;
    glm::dvec3 velocity = impulse * double(body.getInvMass());
    if (const double speed = glm::length(velocity); speed > kFastestOfBlow) velocity *= kFastestOfBlow / speed;
    body.setLinearVelocity(body.getLinearVelocity() + to_bullet(velocity));
    body.setAngularVelocity(body.getAngularVelocity() + to_bullet(spin));
}

}  // namespace kerf::sim
