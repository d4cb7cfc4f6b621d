#pragma once

#include <array>

#include "common/cutting/cut_geometry.h"
#include "common/mesh/index.h"
#include "common/mesh/side.h"
#include "halfedge/universe/ids.h"

// What the plane meets: triangles that it crosses, and edges that lie in it.

namespace kerf::core::halfedge {

/// A point where an edge meets the plane: a place in Section::cut_points.
using CutPointId = Id<struct CutPointKind>;

/// Where triangles go: a place in Pieces::targets (planned_pieces.h).
using TargetId = Id<struct TargetKind>;

/// A triangle with corners strictly on both sides. FIND notes where it is, SPLIT how it falls apart, WALK its cut
/// points and their vertices, and the plan of the pieces where its sub-triangles go.
///
///              lone (+)              The section runs through the triangle from its entry edge (positive to negative
///              /  \                  corner) to its exit edge (negative to positive), as seen in the surface of the
///     entry N /--->\ P exit          positive side. N and P are the cut points of split_triangle(): if the lone corner
///            /      \                is positive, as here, N is on the entry edge and P on the exit edge, otherwise the
///      next (-) -- previous (-)      other way round.
struct Crossing
{
    // FIND
    SlotId slot;
    FaceId face;
    GroupId group;
    Index shell = 0;                 ///< which of the cut shells
    std::array<VertexId, 3> corner;  ///< its vertices
    std::array<double, 3> distance;

    // SPLIT
    std::array<HalfedgeId, 3> halfedge;  ///< halfedge[i] leaves corner i; before the cut
    std::array<PointId, 3> point;        ///< at the corners; before the cut
    TriangleSplit split;
    /// The crossing triangles beyond the edges of N and P. None: a boundary, or an edge that only touches the plane.
    Index beyond_n = kNone, beyond_p = kNone;

    // WALK
    bool walked = false;
    /// Not valid: the section runs through an end point of that edge, which stays whole.
    CutPointId entry_cut_point, exit_cut_point;
    VertexId entry_vertex, exit_vertex;  ///< vertices at the cut points, if a sub-triangle needs them

    // The plan of the pieces
    BySide<TargetId> target{};  ///< of its sub-triangles
    /// No triangle is left at the section edge: no sub-triangle, and none beyond it. Open meshes only.
    BySide<bool> bounds_nothing{};

    bool lone_positive() const { return split.lone_side == Side::positive; }
    CutPointId n_cut_point() const { return lone_positive() ? entry_cut_point : exit_cut_point; }
    CutPointId p_cut_point() const { return lone_positive() ? exit_cut_point : entry_cut_point; }
    VertexId n_vertex() const { return lone_positive() ? entry_vertex : exit_vertex; }
    VertexId p_vertex() const { return lone_positive() ? exit_vertex : entry_vertex; }
    int lone() const { return split.lone; }
    int next() const { return (split.lone + 1) % 3; }
    int previous() const { return (split.lone + 2) % 3; }
};

/// An existing edge in the plane between a face kept on the negative and one kept on the positive side.
struct InPlaneEdge
{
    HalfedgeId negative_halfedge, positive_halfedge;
    FaceId negative_face, positive_face;
    GroupId group;
    Index shell = 0;
    VertexId start_vertex;      ///< of the negative face, where the positive half-edge starts
    VertexId end_vertex;        ///< and where it ends
    BySide<TargetId> target{};  ///< where its faces go
};

/// An existing edge in the plane at a face that is kept on the same side as the face across it.
struct FlushEdge
{
    HalfedgeId halfedge;
    FaceId face;
    Side side = Side::negative;
    TargetId target;
};

}  // namespace kerf::core::halfedge
