#pragma once

#include "halfedge/cut_plan.h"

namespace kerf::halfedge {

/// Links the outline where cut points coincide with vertices or with each other, or edges lie in the plane. Points are
/// classes of cut points and vertices that split_triangle() found to coincide, transitively; seams whose ends are one
/// point are dropped, seams that run forth and back between two points cancel, and the rest is decomposed into simple
/// loops and chains. Fills `outline`, `outline_points`, `cancelled` and the loops. Expected O(k).
void link_outline(const Universe& universe, CutScratch& scratch);

/// Links the outline that link_outline() found once more, so that only seams between the same two bundles follow one
/// another. O(k).
void relink_outline(const Universe& universe, CutScratch& scratch);

/// Targets of one side that have triangles at the same two points, in pairs: more than two triangles can meet at an
/// edge where points coincide, and no half-edge leads from one to all others. O(k log k).
std::vector<std::array<Index, 2>> targets_that_share_edges(const Universe& universe, const CutScratch& scratch);

}  // namespace kerf::halfedge
