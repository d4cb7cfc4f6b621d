#pragma once

#include <vector>

#include "common/caps/outline_loops.h"
#include "halfedge/cut/cut_plan.h"

namespace kerf::halfedge {

/// Links the outline where cut points coincide with vertices or with each other, or edges lie in the plane. Points are
/// classes of cut points and vertices that split_triangle() found to coincide, transitively; outline edges whose ends
/// are one point are dropped, outline edges that run forth and back between two points cancel, and the rest is divided
/// into simple loops and chains by solid, as divide_outline() does. Fills `outline`, `outline_points`, `cancelled` and
/// the loops. Expected O(k), and O(j log j) for the j outline edges where several meet.
void link_outline(const Universe& universe, const Plane& plane, CutScratch& scratch);

/// Divides the outline that link_outline() found once more: only outline edges between the same two piece shells follow
/// one another.
void relink_outline(const Universe& universe, const Plane& plane, CutScratch& scratch);

/// The outline edges of an irregular outline as common code takes them, but for the parts that they bound. O(k).
std::vector<OutlineEdge> outline_edges(const Universe& universe, const CutScratch& scratch);

/// Targets of one side that have triangles at the same two points, in pairs: more than two triangles can meet at an
/// edge where points coincide, and no half-edge leads from one to all others. O(k log k).
std::vector<std::array<Index, 2>> targets_that_share_edges(const Universe& universe, const CutScratch& scratch);

/// Marks the outline edges of an irregular outline at which a side keeps no triangle: all of theirs there has shrunk
/// away, and it lay at the boundary of an open mesh. O(k), and O(k log k) where a crossing triangle has lost a piece at
/// its outline edge.
void find_edges_that_bound_nothing(const Universe& universe, CutScratch& scratch);

}  // namespace kerf::halfedge
