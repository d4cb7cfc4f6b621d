#pragma once

#include "halfedge/cut/cut_plan.h"

namespace kerf::halfedge {

/// Writes a planned cut into the half-edge mesh. Each crossing triangle becomes three faces and each crossed edge two;
/// faces that split_triangle() lets vanish are then contracted, which makes their two remaining half-edges opposite to
/// each other; the caps are sewn to the outline. O(k), plus the valence of vertices on the plane.
///
/// plan() may throw std::bad_alloc; run() can't fail.
class Stitcher
{
public:
    /// Counts what the cut adds and makes room for it. Returns the bytes by which the mesh grew.
    std::size_t plan(Universe& universe, const CutScratch& scratch);
    void run(Universe& universe, CutScratch& scratch);

    /// One of the up to three pieces of a crossing triangle, as a face.
    struct SubFace
    {
        Index face = kNone;
        bool exists = false;  ///< false: corners coincide, and the face is contracted
        Side side = Side::positive;
        std::array<std::uint8_t, 3>
            corners{};  ///< codes of split_triangle(), from the origin of the face's half-edge on
    };
    static std::array<SubFace, 3> sub_faces(const Crossing& crossing, Index crossing_number, Index first_new_face);

    Index first_piece_face() const { return faces0_; }
    /// The face of cap triangle t on one side.
    Index cap_face(Side side, Index t) const { return first_cap_face_ + static_cast<Index>(side) * cap_count_ + t; }

private:
    /// Some vertices can't be told from cut points alone.
    bool needs_orbits(const CutScratch& scratch) const { return scratch.any_shared || !scratch.cancelled.empty(); }

    // Numbers of what is new, in blocks behind what the mesh has.
    Index vertices0_ = 0, edges0_ = 0, faces0_ = 0;
    Index first_diagonal_ = 0, first_section_ = 0, first_in_plane_ = 0, first_cap_edge_ = 0, cap_edge_count_ = 0;
    Index first_cap_face_ = 0, cap_count_ = 0;
    std::size_t edges_ = 0, faces_ = 0, vertices_ = 0;

    std::vector<Index> cap_half_;       // for each outline edge and side the half-edge that waits for a cap
    std::vector<Index> cap_edge_;       // for each cap triangle and edge its half-edge, on the negative side
    std::vector<bool> edge_is_closed_;  // linked to a cap, or cancelled
    std::vector<Index> vanished_;       // faces with two half-edges
    std::vector<Index> boundary_;       // boundary half-edges whose neighbours change
    std::vector<Index> touched_;        // half-edges that were glued
    std::vector<Index> orbit_start_, orbit_label_, order_;

    friend class StitchRun;
};

}  // namespace kerf::halfedge
