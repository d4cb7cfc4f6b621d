#pragma once

#include "halfedge/cut_plan.h"

namespace kerf::halfedge {

/// Links the outline where cut points coincide with vertices or with each other, or edges lie in the plane. Points are
/// classes of cut points and vertices that split_triangle() found to coincide, transitively; seams whose ends are one
/// point are dropped, seams that run forth and back between two points cancel, and the rest is decomposed into simple
/// loops and chains. Expected O(k).
void link_outline(const Universe& universe, CutScratch& scratch);

}  // namespace kerf::halfedge
