#pragma once

#include "halfedge/cut/stitch_plan.h"

// STITCH: writes a planned cut into the half-edge mesh. Each crossing triangle becomes three faces and each crossed
// edge two. Faces that split_triangle() lets vanish are contracted. The caps are sewn to the outline. Result: the mesh,
// and StitchPlan, which says what is where in it.

namespace kerf::core::halfedge {

/// Counts what the cut adds and makes room for it. Returns the bytes by which the mesh grew. O(k). May throw
/// std::bad_alloc.
std::size_t plan_stitch(Universe& universe, const Found& found, const Section& section, const Caps& caps,
                        StitchPlan& plan);

/// Does it. O(k), plus the valence of vertices on the plane. Can't fail.
void stitch(Universe& universe, const Found& found, const Section& section, const Caps& caps, StitchPlan& plan);

}  // namespace kerf::core::halfedge
