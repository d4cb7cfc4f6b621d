#pragma once

#include <array>
#include <vector>

#include "halfedge/cut/caps.h"
#include "halfedge/cut/section.h"

// What STITCH will do, worked out before anything is changed. Result: StitchPlan.

namespace kerf::core::halfedge {

/// One of the up to three sub-triangles of a crossing triangle, as a face.
struct SubFace
{
    FaceId face;
    bool exists = false;  ///< false: corners coincide, and the face is contracted
    Side side = Side::positive;
    std::array<std::uint8_t, 3> corners{};  ///< codes of split_triangle(), from the origin of the face's half-edge on
};

/// Which diagonal divides the far side of a crossing triangle: N - previous, or next - P. If sub-triangles vanish it is
/// the diagonal between the corners that coincide.
bool diagonal_from_n(const Crossing& crossing);

/// What a cut adds to the half-edge mesh: numbers of what is new, in blocks behind what the mesh has, and lists that
/// the steps of a run hand on.
struct StitchPlan
{
    Index points0 = 0, edges0 = 0, faces0 = 0;  ///< what the mesh has
    // The first edge and face of each block
    Index first_diagonal = 0, first_section = 0, first_in_plane = 0, first_cap_edge = 0, first_cap_face = 0;
    Index cap_edge_count = 0, cap_count = 0;       ///< on each side
    std::size_t points = 0, edges = 0, faces = 0;  ///< how many are new, at most

    std::vector<HalfedgeId> cap_halfedges;  ///< for each outline edge and side the one that waits for a cap
    std::vector<HalfedgeId> cap_edges;      ///< for each cap triangle and edge its half-edge, on the negative side
    std::vector<bool> edge_is_closed;       ///< linked to a cap, or cancelled
    std::vector<HalfedgeId> boundary;       ///< those whose neighbours change

    // Irregular sections
    std::vector<FaceId> vanished;     ///< faces with two half-edges
    std::vector<HalfedgeId> touched;  ///< those that were glued
    std::vector<HalfedgeId> orbit_start;
    std::vector<Index> orbit_label, order;

    /// The point at a cut point.
    PointId cut_point(CutPointId cut_point, Side side) const
    {
        return PointId(int(points0 + 2 * cut_point.number()) + int(side));
    }

    /// The half of half-edge h, which is divided at a cut point, on the negative side. The positive half keeps the
    /// number.
    HalfedgeId negative_half(HalfedgeId h, CutPointId cut_point) const
    {
        const HalfedgeId first = first_halfedge(EdgeId(int(edges0 + cut_point.number())));
        return h == first_halfedge(edge_of(h)) ? first : opposite(first);
    }

    /// The half-edge at an outline edge that waits for a cap.
    HalfedgeId& cap_halfedge(OutlineEdgeId edge, Side side) { return cap_halfedges[2 * edge.number() + Index(side)]; }

    /// The half-edge of a section edge that belongs to the surface; its opposite waits for the cap.
    HalfedgeId section_halfedge(Index crossing, Side side) const
    {
        return first_halfedge(EdgeId(int(first_section + 2 * crossing) + int(side)));
    }
    /// The edge that divides the far side of a crossing triangle.
    HalfedgeId diagonal(Index crossing) const { return first_halfedge(EdgeId(int(first_diagonal + crossing))); }
    /// The edge that an in-plane edge gets on the negative side.
    HalfedgeId in_plane_copy(Index number) const { return first_halfedge(EdgeId(int(first_in_plane + number))); }

    /// The half-edge of a cap on the positive side, given that of the negative side.
    HalfedgeId on_positive_side(HalfedgeId h) const { return HalfedgeId(h.idx() + 2 * int(cap_edge_count)); }
    /// The face of cap triangle t on one side.
    FaceId cap_face(Side side, Index t) const { return FaceId(int(first_cap_face + Index(side) * cap_count + t)); }
    bool is_of_cap(FaceId face) const { return number_of(face) >= first_cap_face; }

    /// The faces of a crossing triangle's sub-triangles. The first one keeps its face; the others are two new faces for
    /// each.
    std::array<SubFace, 3> sub_faces(const Crossing& crossing, Index number) const;
    /// The new faces among them.
    std::array<FaceId, 2> new_faces(Index crossing) const
    {
        const int first = int(faces0 + 2 * crossing);
        return {FaceId(first), FaceId(first + 1)};
    }

    // A half-edge that waits for its cap has no face yet. So that it can be moved meanwhile, it gets the number of a
    // face that will never be, which names its place in `cap_halfedges`.
    FaceId waiting_face(Index place) const { return FaceId(int(first_cap_face + 2 * cap_count + place)); }
    bool is_waiting(FaceId face) const { return face.is_valid() && !(face < waiting_face(0)); }
    Index place_of_waiting(FaceId face) const { return number_of(face) - number_of(waiting_face(0)); }
};

/// Some vertices can't be told from cut points alone.
inline bool needs_orbits(const Section& section)
{
    return section.any_shared || !section.cancelled.empty();
}

/// Whether more than one vertex may be at a point of the outline on a side.
inline bool is_shared_point(const Found& found, const Section& section, Index loop_point)
{
    const OutlineEdgeId edge = section.loop_edges[loop_point];
    return !found.is_crossing(edge) || section.is_shared(found.crossing(edge).entry_cut_point);
}

/// The same of either end of an outline edge.
inline bool is_shared_edge(const Found& found, const Section& section, OutlineEdgeId edge)
{
    return !found.is_crossing(edge) || section.is_shared(found.crossing(edge));
}

/// If the half-edge `from` represents the point that it leaves, `to` does so instead.
inline void move_outgoing(SurfaceMesh& mesh, PointId point, HalfedgeId from, HalfedgeId to)
{
    if (mesh.halfedge_of(point) == from) mesh.set_halfedge_of(point, to);
}

}  // namespace kerf::core::halfedge
