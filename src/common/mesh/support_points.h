#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/support_directions.h"

// The extreme vertices of a mesh along fixed directions: what its bounded hull is made of.

namespace kerf::core {

/// dot(direction, p) in float. All searches for extreme vertices use this one order of operations, so that a maximum
/// found in a tree and one found in a loop are the same number. Infinite values (of coordinates beyond 2e38) are equal,
/// too.
inline float support_value(const glm::vec3& direction, const glm::vec3& p)
{
    return (direction.x * p.x + direction.y * p.y) + direction.z * p.z;
}

/// For each support direction the extreme vertex: largest support value; among equals the lexicographically smallest
/// position, so that the answer depends on the positions only and not on their order. The origin if there are no
/// vertices. O(vertices * kSupportDirections).
std::array<glm::vec3, kSupportDirections> support_points(std::span<const Vertex> vertices);

}  // namespace kerf::core
