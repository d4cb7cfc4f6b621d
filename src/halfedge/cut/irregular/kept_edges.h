#pragma once

#include <array>
#include <vector>

#include "halfedge/cut/section.h"

namespace kerf::halfedge {

/// Targets of one side that have triangles at the same two points, in pairs: more than two triangles can meet at an
/// edge where points coincide, and no half-edge leads from one to all others. O(k log k).
std::vector<std::array<Index, 2>> targets_that_share_edges(const Universe& universe, const Found& found,
                                                           const Section& section);

/// Marks the outline edges of an irregular outline at which a side keeps no triangle: all of theirs there has shrunk
/// away, and it lay at the boundary of an open mesh. O(k), and O(k log k) if a crossing triangle has lost the
/// sub-triangle at its outline edge.
void find_edges_that_bound_nothing(const Universe& universe, const Section& section, Found& found);

}  // namespace kerf::halfedge
