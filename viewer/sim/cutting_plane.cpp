#include "viewer/sim/cutting_plane.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace kerf::sim {

std::optional<WorldPlane> swipe_plane(const glm::dvec3& eye, const glm::dvec2& from, const glm::dvec2& to)
{
    const glm::dvec3 a = glm::dvec3(from, 0.0) - eye, b = glm::dvec3(to, 0.0) - eye;
    // For a stroke to the right, b x a would point down: left of the stroke is up.
    const glm::dvec3 normal = glm::cross(b, a);
    const double length = glm::length(normal);
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    return WorldPlane{normal / length, eye};
}

std::optional<Plane> object_plane(const WorldPlane& plane, const MeshPose& pose, const Origin& origin)
{
    // n . (s R p + t - q) = 0 in the mesh's own coordinates.
    const glm::dvec3 normal = pose.scale * (glm::transpose(pose.rotation) * plane.normal);
    const double length = glm::length(normal);
    const double offset = glm::dot(plane.normal, plane.point - pose.translation);
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(offset)) return std::nullopt;

    const auto on_grid = [](double value) { return std::round(value / kPlaneGrid) * kPlaneGrid; };
    const glm::dvec3 unit = normal / length;
    const glm::dvec3 snapped(on_grid(unit.x), on_grid(unit.y), on_grid(unit.z));
    const double distance = (offset / length - glm::dot(unit, origin.centre)) / origin.radius;
    const glm::dvec3 direction = glm::normalize(snapped);
    return Plane::at(Point(origin.centre + on_grid(distance) * origin.radius * direction), Normal(snapped));
}

WorldPlane world_plane(const Plane& plane, const MeshPose& pose)
{
    const glm::dvec3 normal(plane.normal());
    return {glm::normalize(pose.rotation * normal), pose.to_world(plane.offset() * normal)};
}

}  // namespace kerf::sim
