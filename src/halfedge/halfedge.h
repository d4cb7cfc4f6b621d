#pragma once

#include <memory>

#include "common/cutting/cut.h"

namespace kerf::core::halfedge {

/// The back end whose cut costs what the section costs: O(k log k + s log n) for k crossing triangles and s leaves of
/// the tree that the plane meets, instead of O(n). docs/halfedge.md explains how.
std::unique_ptr<Backend> make_back_end();

/// The same, and a constrained Delaunay triangulation closes every section, as if CapQuality::delaunay were asked for:
/// "halfedge/cgal", to be compared with. Where can_close() says no, others take its place.
std::unique_ptr<Backend> make_back_end_with_cgal();

}  // namespace kerf::core::halfedge
