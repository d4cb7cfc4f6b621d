#pragma once

#include <glm/vec3.hpp>

namespace kerf::core {

/// True if `a` comes before `b` in the order by x, then y, then z.
inline bool lexicographically_less(const glm::vec3& a, const glm::vec3& b)
{
    if (a.x != b.x) return a.x < b.x;
    if (a.y != b.y) return a.y < b.y;
    return a.z < b.z;
}

/// Bit-equal positions; -0 does not occur in a mesh, so this is ==.
inline bool same_position(const glm::vec3& a, const glm::vec3& b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

}  // namespace kerf::core
