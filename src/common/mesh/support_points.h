#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "common/mesh/indexed_mesh.h"

// The extreme vertices of a mesh along fixed directions: what its bounded hull is made of.

namespace kerf {

/// Number of directions of the bounded hull, hence the bound on its points.
inline constexpr std::size_t kSupportDirections = 32;

/// The fixed unit directions of the bounded hull: sixteen lines, then the same lines in the opposite direction, bit for
/// bit the negatives (i and i + 16 belong together). The first three are the axes. No direction in space is farther
/// than 24.6 degrees from one of them.
const std::array<glm::vec3, kSupportDirections>& support_directions();

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

}  // namespace kerf
