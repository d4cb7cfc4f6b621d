#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"
#include "common/caps/edge_routes.h"

namespace kerf {

/// Outlines that touch or cross themselves: an edge that meets a point, or crosses an edge beside it, is led over that
/// point by a triangle with (almost) no area; where edges cross farther than rounding from their ends, both are led
/// over a new point. Then as the constrained triangulator. Covers what the outline winds around up to these triangles.
/// Refuses outlines that cross themselves all over. O((k + meetings) log k).
/// @param constrained  covers what has been untangled
/// @param finder       finds where edges meet that cross all over
std::unique_ptr<CapTriangulator> make_untangling_triangulator(std::unique_ptr<CapTriangulator> constrained,
                                                              std::unique_ptr<RouteFinder> finder);

}  // namespace kerf
