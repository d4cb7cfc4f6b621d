#pragma once

#include <array>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "common/cutting/cut_geometry.h"
#include "common/geometry/disjoint_sets.h"
#include "halfedge/cut/planned_pieces.h"
#include "halfedge/cut/section.h"

// Which triangles of a side are connected: parts. Which parts make a piece: piece_plan.h, by
// common/cutting/group_pieces.h.

namespace kerf::core::halfedge {

/// Finds the triangles on each side of a cut that are connected by half-edges. One curve on a connected shell leaves
/// one part on each side, for any genus, and costs nothing. If there are more curves, a search starts from each of them
/// on both sides. The searches take turns, and those that meet become one, until all but the last on each side have
/// nothing left to visit: the cost is that of the smaller parts, not of the largest one. Exact: the result is that of a
/// flood fill. Only a shell that an earlier cut left in an unknown state is flooded as a whole.
class PartFinder
{
public:
    /// Gives every part that is not the largest of its side a target of its own, and rewrites the programs, entries and
    /// crossing triangles accordingly. May throw std::bad_alloc.
    void separate(Universe& universe, const Section& section, Found& found, Pieces& pieces);

    /// The number of stamps that the last call has put on faces beside those of the crossing triangles.
    std::uint64_t stamps_used() const { return stamps_used_; }
    void forget_stamps() { stamps_used_ = 0; }

private:
    struct Search
    {
        Side side;
        std::vector<FaceId> faces;  // reached, in the order in which they are looked at
        std::size_t next = 0;
        TargetId target;
        bool is_empty = false;  // reached nothing but triangles that vanished
    };

    void search_shell(Index shell);
    void start(FaceId face, Side side);
    void advance(Index search);
    void reach(FaceId face, Index search);
    bool is_finished(Index search) const { return searches_[search].next == searches_[search].faces.size(); }
    void search_side(Side side, bool connected);
    Index crossing_of(FaceId face) const;
    /// Whether the side gets a triangle of the face: sub-triangles of a crossing triangle may vanish.
    bool keeps_something(FaceId face, Side side) const;
    HalfedgeId beyond_pinched(HalfedgeId halfedge, Side side) const;
    template <class Visit>
    void for_each_neighbour(FaceId face, Side side, Visit visit) const;
    void seed_whole_shell(Index shell);
    void assign_targets(Index shell);
    void retarget(Index shell);
    void open_subtree(NodeId root, Side side, Index shell);
    /// The target of a face that is kept.
    TargetId target_of(FaceId face, Side side, Index shell) const;

    Universe* u_ = nullptr;
    const Section* section_ = nullptr;
    Found* found_ = nullptr;
    Pieces* pieces_ = nullptr;
    std::vector<Search> searches_;
    DisjointSets met_{0};  // of the searches
    std::uint64_t stamps_used_ = 0;
    std::vector<BySide<Index>> crossing_mark_;  // search that has reached a crossing triangle
    std::uint64_t mark_base_ = 0;               // stamps of kept faces: this + search
    bool any_pinched_ = false;                  // some crossing triangle shrinks to two edges on its far side
    std::unordered_set<EdgeId> in_plane_edges_;
    BySide<std::unordered_multimap<FaceId, FaceId>> glued_;  // faces joined by outline edges that cancel
    std::vector<TreeOp> ops_;
    std::vector<std::pair<NodeId, bool>> stack_;
    BySide<Box> small_parts_;  // what the parts that are not the largest reach
};

}  // namespace kerf::core::halfedge
