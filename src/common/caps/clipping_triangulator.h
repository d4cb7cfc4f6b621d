#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"

namespace kerf {

/// One simple concave loop, by clipping ears in layers: as few triangles along a line as Delaunay's, at a fraction of
/// the cost. Refuses loops that have few ears at a time. O(k log k).
std::unique_ptr<CapTriangulator> make_clipping_triangulator();

}  // namespace kerf
