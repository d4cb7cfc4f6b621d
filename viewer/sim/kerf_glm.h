#pragma once

#include <kerf/math.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

// Between the library's numbers and GLM's, where naming the type is not enough.

namespace kerf::sim {

inline glm::dmat3 to_glm(const Mat3d& matrix)
{
    glm::dmat3 result;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) result[column][row] = matrix.m[column][row];
    return result;
}

inline glm::dvec3 centre_of(const Box& box)
{
    return 0.5 * (glm::dvec3(glm::vec3(box.lo)) + glm::dvec3(glm::vec3(box.hi)));
}

inline glm::dvec3 extent_of(const Box& box)
{
    return glm::dvec3(glm::vec3(box.hi)) - glm::dvec3(glm::vec3(box.lo));
}

/// Half the diagonal.
inline double radius_of(const Box& box)
{
    return 0.5 * glm::length(extent_of(box));
}

/// The largest absolute coordinate in it.
inline float largest_coordinate(const Box& box)
{
    return std::max({std::abs(box.lo.x), std::abs(box.lo.y), std::abs(box.lo.z), std::abs(box.hi.x), std::abs(box.hi.y),
                     std::abs(box.hi.z)});
}

}  // namespace kerf::sim
