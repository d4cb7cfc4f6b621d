#pragma once

#include <BulletDynamics/Dynamics/btRigidBody.h>
#include <LinearMath/btAabbUtil2.h>

#include <utility>

#include "viewer/sim/body.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/sim/world.h"
#include "viewer/support/stages.h"

namespace kerf::test {

/// A body out of a mesh, one metre a unit, with its box's centre at `centre`.
inline std::unique_ptr<sim::Body> body_of(const Mesh& mesh, sim::ObjectId id, const glm::dvec3& centre,
                                          const sim::Motion& motion = {},
                                          sim::ProxyKind proxy = sim::ProxyKind::full_hull,
                                          const std::string& backend = "baseline/remap")
{
    const glm::dvec3 middle = sim::centre_of(mesh.bounds());
    Object object = object_of(mesh, backend);
    sim::Identity identity;
    identity.id = id;
    identity.origin.backend = backend;
    identity.origin.centre = middle;
    sim::MeshPose pose;
    pose.translation = centre - middle;
    const sim::Solid solid = sim::solid_of(object.mass_properties(), object.bounds(), 1.0);
    return std::make_unique<sim::Body>(std::move(identity), std::move(object), solid, pose, motion, proxy);
}

/// Pairs of bodies whose boxes overlap, which Bullet looks at in every tick. O(n^2).
inline std::size_t overlapping_pairs(const sim::World& world)
{
    std::size_t pairs = 0;
    for (const auto& a : world.bodies())
        for (const auto& b : world.bodies()) {
            btVector3 a_lo, a_hi, b_lo, b_hi;
            a->rigid_body().getAabb(a_lo, a_hi);
            b->rigid_body().getAabb(b_lo, b_hi);
            if (a->id() < b->id() && TestAabbAgainstAabb2(a_lo, a_hi, b_lo, b_hi)) ++pairs;
        }
    return pairs;
}

}  // namespace kerf::test
