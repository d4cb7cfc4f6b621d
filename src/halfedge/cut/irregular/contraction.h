#pragma once

#include <array>
#include <vector>

#include "halfedge/cut/stitch_plan.h"

namespace kerf::halfedge {

/// Gives what lies in the plane an edge on each side, and takes out of the half-edge mesh what has no area: faces that
/// split_triangle() lets vanish, and outline edges that run forth and back. Their two remaining half-edges become
/// opposite to each other. O(k).
class Contraction
{
public:
    Contraction(StitchPlan& plan, SurfaceMesh& mesh) : plan_(plan), mesh_(mesh) {}

    /// The edge stays with the positive face; the negative face gets an edge of its own.
    void open_in_plane_edge(const Found& found, Index number);

    /// Contracts the faces that have vanished and the outline edges that cancel.
    void run(const std::vector<std::array<OutlineEdgeId, 2>>& cancelled);

private:
    void mark_waiting();
    void move_halfedge(HalfedgeId from, HalfedgeId to);
    void contract(HalfedgeId x, HalfedgeId y);
    void contract_face(FaceId face);

    StitchPlan& plan_;
    SurfaceMesh& mesh_;
};

}  // namespace kerf::halfedge
