#pragma once

#include <span>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/tolerances.h"

namespace kerf::core {

/// The distance between neighbouring floats at the largest coordinate, in mesh units: how coarse positions are.
double coordinate_grain(const Box& box);

/// Length of the shortest edge, in mesh units; infinite if there is none. Edges between equal positions and triangles
/// with an index out of range do not count. O(n).
double shortest_edge(std::span<const Vertex> vertices, std::span<const Triangle> triangles);

/// True if the shortest edge is below kCoarseUnits times the grain, as in a small mesh far from the origin. Such a mesh
/// is still cut closed and without a crash; if you can, move it to the origin before it is rounded to float.
inline bool has_coarse_coordinates(double shortest_edge, const Box& box)
{
    return shortest_edge < kCoarseUnits * coordinate_grain(box);
}

}  // namespace kerf::core
