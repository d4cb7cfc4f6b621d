#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

namespace kerf::maker {

/// Divides a simple, nearly flat polygon into its n - 2 triangles, corner numbers in the polygon's order: the
/// triangulation of smallest total cost, where slender triangles are dear, by dynamic programming (Klincsek 1980).
/// Only triangles that face the polygon's way are used, so no two overlap. O(n^3). Throws std::logic_error when there
/// is none, which means that the polygon crosses itself.
std::vector<std::array<int, 3>> triangulate(const std::vector<glm::dvec3>& polygon);

}  // namespace kerf::maker
