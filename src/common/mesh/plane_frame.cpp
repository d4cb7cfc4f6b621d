#include "common/mesh/plane_frame.h"

#include <algorithm>
#include <glm/common.hpp>

#include "common/mesh/tolerances.h"

namespace kerf::core {

PlaneFrame PlaneFrame::of(const glm::dvec3& normal, double uv_scale)
{
    // Start from the axis that is farthest from the normal, so the cross product is never short.
    const glm::dvec3 size = glm::abs(normal);
    glm::dvec3 axis{0, 0, 1};
    if (size.x <= size.y && size.x <= size.z)
        axis = {1, 0, 0};
    else if (size.y <= size.z)
        axis = {0, 1, 0};
    const glm::dvec3 u = glm::normalize(glm::cross(axis, normal));
    return {u, glm::cross(normal, u), uv_scale};
}

PlaneFrame PlaneFrame::upright(const glm::dvec3& normal, const glm::dvec3& up)
{
    // Scaled first, so that no square leaves the range of double.
    const glm::dvec3 size = glm::abs(up);
    const glm::dvec3 direction = up / std::max({size.x, size.y, size.z});
    const glm::dvec3 u = glm::cross(direction, normal);
    const double length = glm::length(u);
    if (!(length > kNoDirection)) return of(normal);
    return {u / length, glm::cross(normal, u / length), 1.0};
}

}  // namespace kerf::core
