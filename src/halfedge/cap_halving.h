#pragma once

#include "halfedge/cap_triangulator.h"

namespace kerf::halfedge {

/// Triangulates one loop by its order alone. `ring` holds the points' numbers; seam i of `ring` is the edge from
/// ring[i] to its successor, reported under the number ring[i]. Equal positions are never joined by a diagonal, so no
/// triangle has two corners at one place: `ring` must have no two consecutive edges that run forth and back. Appends to
/// `triangles`.
void halve_loop(std::span<const glm::vec3> positions, std::span<const Index> ring, std::vector<CapTriangle>& triangles);

}  // namespace kerf::halfedge
