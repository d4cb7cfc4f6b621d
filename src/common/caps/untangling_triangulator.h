#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"
#include "common/caps/edge_routes.h"

namespace kerf::core {

/// Closes outlines that touch or cross themselves. An edge that meets a point, or crosses an edge beside it, is led
/// over that point by a triangle with (almost) no area; edges that cross farther than rounding from their ends are both
/// led over a new point. Then continues as the constrained triangulator. Covers the area that the outline winds around
/// up to these triangles. Refuses outlines that cross themselves everywhere. O((k + meetings) log k).
/// @param constrained  covers what has been untangled
/// @param finder       finds where edges meet, however many cross
std::unique_ptr<CapTriangulator> make_untangling_triangulator(std::unique_ptr<CapTriangulator> constrained,
                                                              std::unique_ptr<RouteFinder> finder);

}  // namespace kerf::core
