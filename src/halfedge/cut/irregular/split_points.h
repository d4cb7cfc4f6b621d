#pragma once

#include "halfedge/cut/stitch_plan.h"

namespace kerf::halfedge {

/// Gives each vertex fan at a shared point one point of the half-edge mesh. A point in the plane falls apart if its
/// faces are divided between the sides or if several loops run through it; cut points that coincide become one. Every
/// such fan has a face that is a sub-triangle or a cap triangle, lies at an outline edge, or was glued. O(k log k),
/// plus the valence of the points in the plane.
void split_points(StitchPlan& plan, SurfaceMesh& mesh, const Found& found, const Section& section, const Caps& caps);

}  // namespace kerf::halfedge
