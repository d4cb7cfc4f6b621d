#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"
#include "common/caps/edge_routes.h"

// The part that needs CGAL, which is GPL: defined in the library `caps_cgal`, in one file. A build without CGAL has the
// library `caps_refuse` in its place, whose ways refuse every outline.

namespace kerf::core {

/// Concave and nested loops: constrained Delaunay triangulation of spatially sorted points, then winding numbers by
/// flooding from outside. Refuses outlines that cross or touch themselves inside an edge. O(k log k).
std::unique_ptr<CapTriangulator> make_constrained_triangulator();

/// By a constrained Delaunay triangulation whose constraints may cross.
std::unique_ptr<RouteFinder> make_route_finder();

}  // namespace kerf::core
