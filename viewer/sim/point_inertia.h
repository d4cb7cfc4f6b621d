#pragma once

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace kerf::sim {

/// |d|^2 - d d': what a unit mass at d adds to an inertia tensor about the origin.
inline glm::dmat3 point_inertia(const glm::dvec3& d)
{
    return glm::dmat3(glm::dot(d, d)) - glm::outerProduct(d, d);
}

}  // namespace kerf::sim
