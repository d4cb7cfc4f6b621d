#pragma once

#include <cstdint>
#include <vector>

#include "bench/peers/peer_inputs.h"
#include "bench/peers/peer_row.h"

namespace kerf::bench {

/// A mesh and the points of the cells that it is broken into, those of the benchmark Fracture.
struct CellInput : BareMesh
{
    std::vector<Vec3d> sites;
    double volume = 0.0;
};

/// The asteroid of about so many triangles.
CellInput asteroid_cell_input(std::uint64_t triangles, std::uint32_t cells);

/// Cell by cell: a copy is clipped by the planes half way to other points, the nearest first, until all that are left are
/// farther away than twice the cell's radius, with CGAL's Polygon_mesh_processing::clip and clip_volume. `planes` of the row
/// are cells. Copying is not timed.
PeerRow time_cgal_cells(const CellInput& input, double budget_seconds);

}  // namespace kerf::bench
