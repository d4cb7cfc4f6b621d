#include "common/mesh/plane_frame.h"

#include <glm/common.hpp>

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

}  // namespace kerf::core
