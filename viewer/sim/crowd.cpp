#include "viewer/sim/crowd.h"

#include <BulletDynamics/Dynamics/btRigidBody.h>

#include <algorithm>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "viewer/sim/kerf_glm.h"

namespace kerf::sim {
namespace {

WorldBox world_box(const Body& body)
{
    btVector3 lo, hi;
    body.rigid_body().getAabb(lo, hi);
    return {{lo.x(), lo.y(), lo.z()}, {hi.x(), hi.y(), hi.z()}};
}

}  // namespace

bool WorldBox::overlaps(const WorldBox& other) const
{
    return glm::all(glm::lessThanEqual(lo, other.hi)) && glm::all(glm::lessThanEqual(other.lo, hi));
}

WorldBox world_box(const Box& box, const MeshPose& pose)
{
    const glm::dvec3 centre = pose.to_world(centre_of(box));
    const glm::dvec3 half = 0.5 * pose.scale * extent_of(box);
    const glm::dmat3& r = pose.rotation;
    const glm::dvec3 reach = glm::abs(r[0]) * half.x + glm::abs(r[1]) * half.y + glm::abs(r[2]) * half.z;
    return {centre - reach, centre + reach};
}

Crowd::Crowd(const World& world)
{
    for (const std::unique_ptr<Body>& body : world.bodies()) boxes_.push_back(world_box(*body));
}

bool Crowd::is_thick_at(const WorldBox& box, std::size_t many) const
{
    const auto neighbours =
        std::count_if(boxes_.begin(), boxes_.end(), [&](const WorldBox& other) { return box.overlaps(other); });
    return std::size_t(neighbours) >= many;
}

}  // namespace kerf::sim
