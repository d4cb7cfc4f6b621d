#pragma once

#include <vector>

#include "common/caps/outline_loops.h"
#include "halfedge/cut/planned_pieces.h"
#include "halfedge/cut/section.h"

namespace kerf::halfedge {

/// Links the outline if cut points coincide with vertices or with each other, or if edges lie in the plane. The points
/// of the outline are classes of cut points and vertices that split_triangle() found to coincide, transitively. Outline
/// edges whose ends are one point are dropped, and those that run back and forth between two points cancel.
/// divide_outline() divides the rest into simple loops and chains, by solid. Fills `outline`, `outline_points`,
/// `cancelled` and the loops. Expected O(k), and O(j log j) for the j outline edges at points where several meet.
void link_outline(const Universe& universe, const Plane& plane, const Found& found, Section& section);

/// Divides the outline that link_outline() found once more: only outline edges between the same two piece shells follow
/// one another.
void relink_outline(const Universe& universe, const Plane& plane, const Found& found, const Pieces& pieces,
                    Section& section);

/// The outline edges of an irregular outline as common code takes them, but for the parts that they bound. O(k).
std::vector<OutlineEdge> outline_edges(const Universe& universe, const Found& found, const Section& section);

}  // namespace kerf::halfedge
