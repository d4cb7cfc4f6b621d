#pragma once

#include <cstddef>
#include <vector>

#include "bench/peers/peer_inputs.h"
#include "bench/peers/peer_row.h"

namespace kerf::bench {

/// A row of sections, and what was made before the first of them.
struct SlicerRow
{
    PeerRow row;
    std::size_t heights = 1;  ///< of a stack, for all of which the times are
    double prepare_ms = 0.0;  ///< for the tree; processor time
};

/// CGAL's Polygon_mesh_slicer: closed polylines of each plane, by an AABB tree that is made once. A row for planes, and one
/// for each stack.
std::vector<SlicerRow> time_cgal_slicer(const SectionInput& input, double budget_seconds);

}  // namespace kerf::bench
