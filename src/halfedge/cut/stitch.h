#pragma once

#include "halfedge/cut/stitch_plan.h"

namespace kerf::halfedge {

/// STITCH: writes a planned cut into the half-edge mesh. Each crossing triangle becomes three faces and each crossed
/// edge two. Faces that split_triangle() lets vanish are contracted. The caps are sewn to the outline. O(k), plus the
/// valence of vertices on the plane.
///
/// plan() may throw std::bad_alloc; run() can't fail.
class Stitcher
{
public:
    /// Counts what the cut adds and makes room for it. Returns the bytes by which the mesh grew.
    std::size_t plan(Universe& universe, const Found& found, const Section& section, const Caps& caps);
    void run(Universe& universe, const Found& found, const Section& section, const Caps& caps);

    const StitchPlan& numbers() const { return plan_; }

private:
    StitchPlan plan_;
};

}  // namespace kerf::halfedge
