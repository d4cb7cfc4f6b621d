#include "common/mesh/plane.h"

#include <cmath>

namespace kerf {

std::optional<Plane> Plane::through(const glm::dvec3& point, const glm::dvec3& normal)
{
    // Unlike a plain sum of squares, hypot neither overflows nor underflows.
    const double length = std::hypot(normal.x, normal.y, normal.z);
    if (!(length > 0.0) || !std::isfinite(length)) return std::nullopt;
    Plane plane{normal / length, 0.0};
    plane.offset = (plane.normal.x * point.x + plane.normal.y * point.y) + plane.normal.z * point.z;
    if (!plane.valid()) return std::nullopt;
    return plane;
}

bool Plane::valid() const
{
    const double length = std::hypot(normal.x, normal.y, normal.z);
    return std::isfinite(length) && std::isfinite(offset) && std::abs(length - 1.0) <= kUnitTolerance;
}

PlaneFrame PlaneFrame::of(const glm::dvec3& normal)
{
    // Start from the axis that is farthest from the normal, so the cross product is never short.
    const glm::dvec3 size = glm::abs(normal);
    glm::dvec3 axis{0, 0, 1};
    if (size.x <= size.y && size.x <= size.z)
        axis = {1, 0, 0};
    else if (size.y <= size.z)
        axis = {0, 1, 0};
    const glm::dvec3 u = glm::normalize(glm::cross(axis, normal));
    return {u, glm::cross(normal, u)};
}

double plane_noise(float largest_coordinate)
{
    return kNoiseInUnits * unit_in_last_place(largest_coordinate);
}

}  // namespace kerf
