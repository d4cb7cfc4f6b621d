#pragma once

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"

namespace kerf::core::linear {

/// Gives each fan of triangles around a point near the plane a point of its own, and drops vertices and points that no
/// triangle uses: what IndexedMesh promises holds again after a section that passes a point twice, or shrinks to one. A
/// vertex that is used in several fans is copied. Where more than two triangles meet at an edge they are paired by
/// pair_at_edges(). No triangle changes its place or its attributes.
///
/// @param noise  how far from the plane a point of the section may lie, mesh units
/// O(n), and O(k log k) for k triangles near the plane.
void split_points(IndexedMesh& mesh, const Plane& plane, double noise);

}  // namespace kerf::core::linear
