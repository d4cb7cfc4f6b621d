#pragma once

#include <memory>
#include <span>
#include <vector>

#include "common/caps/cap_triangulator.h"

namespace kerf {

/// Closes one strictly convex loop by halving it repeatedly: no point meets more than 2 log2(k) triangles, and a line
/// crosses O(log k) of them. O(k).
std::unique_ptr<CapTriangulator> make_convex_triangulator();

/// Closes any outline: each loop is halved by its order alone, wherever its points lie. Triangles may overlap and be
/// turned over, but the cap is closed and its signed area is right. The last resort for self-intersecting input. O(k).
std::unique_ptr<CapTriangulator> make_topological_triangulator();

/// Triangulates one loop by its order alone. `ring` holds the points' numbers; edge i of `ring` runs from ring[i] to
/// its successor and is the outline's edge ring[i]. Equal positions are never joined by a diagonal, so no triangle has
/// two corners at one place: `ring` must have no two consecutive edges that run forth and back. Appends to `triangles`.
void halve_loop(std::span<const glm::vec3> positions, std::span<const Index> ring, std::vector<CapTriangle>& triangles);

}  // namespace kerf
