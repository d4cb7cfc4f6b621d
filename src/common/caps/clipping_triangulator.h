#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Closes one simple concave loop by clipping ears in layers: a line crosses as few triangles as in a Delaunay
/// triangulation, at a fraction of the cost. One triangle may be turned over, if it is as thin as rounding
/// (CapMesh::turns_over). Refuses loops that have few ears at a time. O(k log k).
std::unique_ptr<CapTriangulator> make_clipping_triangulator();

}  // namespace kerf::core
