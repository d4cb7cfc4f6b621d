#pragma once

#include <array>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "common/cutting/cut_geometry.h"
#include "halfedge/cut/cut_plan.h"

namespace kerf::halfedge {

/// Which triangles on each side of a cut hang together by half-edges. One curve on a connected shell leaves one part on
/// each side, for any genus, and costs nothing. With more curves a search starts from each of them on both sides; the
/// searches take turns and those that meet become one, until all but the last on each side have nothing left to visit:
/// the cost is that of the smaller parts, not of the largest one. Exact: equal to a flood fill. Only a shell that an
/// earlier cut left in an unknown state is flooded as a whole.
class Components
{
public:
    /// Gives every part that is not the largest of its side a target of its own, and rewrites the programs, entries and
    /// crossing triangles of `scratch` accordingly. May throw std::bad_alloc.
    void separate(Universe& universe, CutScratch& scratch);

private:
    struct Search
    {
        Side side;
        std::vector<Index> faces;  // reached, in the order in which they are looked at
        std::size_t next = 0;
        Index parent;  // union-find over searches
        Index target = kNone;
        bool is_empty = false;  // reached nothing but triangles that vanished
    };

    void search_shell(Index shell);
    void start(Index face, Side side);
    void advance(Index search);
    void reach(Index face, Index search);
    void meet(Index a, Index b);
    Index find(Index search);
    bool is_finished(Index search) const { return searches_[search].next == searches_[search].faces.size(); }
    void search_side(Side side, bool connected);
    Index crossing_of(Index face) const;
    /// Whether the side gets a triangle of the face: pieces of a crossing triangle may vanish.
    bool keeps_something(Index face, Side side) const;
    Index beyond_pinched(Index halfedge, Side side) const;
    template <class Visit>
    void for_each_neighbour(Index face, Side side, Visit visit) const;
    void seed_whole_shell(Index shell);
    void assign_targets(Index shell);
    void retarget(Index shell);
    void open_subtree(Index root, Side side, Index shell);
    /// Where a face that is kept goes.
    Index target_of(Index face, Side side, Index shell) const;

    Universe* u_ = nullptr;
    CutScratch* s_ = nullptr;
    std::vector<Search> searches_;
    std::vector<BySide<Index>> crossing_mark_;  // search that has reached a crossing triangle
    std::uint64_t mark_base_ = 0;               // stamps of kept faces: this + search
    bool any_pinched_ = false;                  // some crossing triangle shrinks to two edges on its far side
    std::unordered_set<Index> in_plane_edges_;
    BySide<std::unordered_multimap<Index, Index>> glued_;  // faces joined by outline edges that cancel
    std::vector<TreeOp> ops_;
    std::vector<std::pair<Index, bool>> stack_;
    BySide<Box> small_parts_;  // what the parts that are not the largest reach
};

}  // namespace kerf::halfedge
