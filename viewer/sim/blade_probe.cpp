#include "viewer/sim/blade_probe.h"

#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpa2.h>
#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "viewer/sim/bullet_glm.h"

namespace kerf::sim {

bool blade_hits(const glm::dvec3& eye, const glm::dvec2& from, const glm::dvec2& to, const Body& body)
{
    const glm::dvec3 centre = body.centre();
    const double radius = body.radius();
    const glm::dvec3 a = glm::dvec3(from, 0.0) - eye, b = glm::dvec3(to, 0.0) - eye;

    // Most bodies are nowhere near the plane of the stroke.
    const glm::dvec3 normal = glm::cross(a, b);
    const double area = glm::length(normal);
    if (!(area > 0.0) || std::abs(glm::dot(normal, centre - eye)) > radius * area) return false;

    // The stroke at the nearest and the farthest depth of the body, in the body's frame.
    const btTransform& frame = body.rigid_body().getCenterOfMassTransform();
    btConvexHullShape sweep;
    sweep.setMargin(0.0f);
    for (const double depth : {eye.z - centre.z - radius, eye.z - centre.z + radius}) {
        const double t = std::max(depth, 0.0) / eye.z;
        for (const glm::dvec3& ray : {a, b})
            sweep.addPoint(to_bullet(eye + t * ray - centre) * frame.getBasis(), false);
    }
    sweep.recalcLocalAabb();

    const btConvexShape& shape = body.proxy().shape();
    btGjkEpaSolver2::sResults closest;
    const btTransform here = btTransform::getIdentity();
    const bool apart = btGjkEpaSolver2::Distance(&sweep, here, &shape, here, btVector3(1.0f, 0.0f, 0.0f), closest);
    if (!apart) return closest.status == btGjkEpaSolver2::sResults::Penetrating;
    // Bullet measures to the shape without its margin. A ball's margin is part of the ball; what hulls are grown by is
    // for the collision engine alone.
    return body.proxy().proxy().kind == ProxyKind::sphere && closest.distance <= shape.getMargin();
}

}  // namespace kerf::sim
