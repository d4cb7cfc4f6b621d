#pragma once

#include <glm/vec3.hpp>
#include <memory>

class btCollisionShape;
class btRigidBody;
class btTransform;

namespace kerf::sim {

/// How heavy a rigid body is.
struct Inertia
{
    double mass = 0.0;        ///< kg
    glm::dvec3 moments{0.0};  ///< about its axes, kg m^2
};

/// One of wood that nothing damps and that never sleeps.
/// @param shape  outlives it
std::unique_ptr<btRigidBody> make_rigid_body(const Inertia& inertia, btCollisionShape& shape, const btTransform& place);

/// A blow adds no more spin than this, rad/s: what is struck at its rim would whirl otherwise.
inline constexpr double kFastestSpinOfBlow = 4.0;

/// And no more speed, m/s: a hammer does not push a crumb with all its weight.
inline constexpr double kFastestOfBlow = 6.0;

/// Deals a rigid body an impulse at a place of the world, N s; no more of it than the two limits let through.
void push(btRigidBody& body, const glm::dvec3& place, const glm::dvec3& impulse);

}  // namespace kerf::sim
