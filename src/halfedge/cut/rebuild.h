#pragma once

#include "halfedge/cut/cut_plan.h"
#include "halfedge/cut/stitch.h"

namespace kerf::halfedge {

/// REBUILD: the trees and the index buffer of both sides. Subtrees that the plane does not meet are handed over by
/// reference; leaves that it meets are written anew at the end of the index buffer, side by side, so that each side's
/// new triangles lie in one run. O(k + s log n) for s straddling leaves.
///
/// plan() may throw std::bad_alloc; run() can't fail.
class Rebuilder
{
public:
    /// Counts what goes where and makes room for it. Returns the bytes grown.
    std::size_t plan(Universe& universe, CutScratch& scratch);

    /// Writes triangles, vertices of caps and nodes; afterwards `piece_shells` have their roots.
    void run(Universe& universe, const Plane& plane, const Stitcher& stitcher, CutScratch& scratch);

    /// What run() added.
    std::size_t new_vertices() const { return new_vertices_; }
    std::size_t new_slots() const { return new_slots_; }

private:
    void count_leaf(const Universe& universe, const TreeOp& op, Index number, CutScratch& scratch);
    void write_cap_vertices(Universe& universe, const Plane& plane, const CutScratch& scratch);
    void rewrite_leaf(Universe& universe, const TreeOp& op, const Stitcher& stitcher, CutScratch& scratch);
    void join_results(Universe& universe);
    void write_caps(Universe& universe, const Stitcher& stitcher, CutScratch& scratch);

    struct Result
    {
        Index target, node;
    };
    std::vector<Result> results_;         // lists of results, one behind the other, each sorted by target
    std::vector<std::uint32_t> lengths_;  // of the lists
    std::vector<Index> touched_;          // targets that a leaf has parts in
    std::vector<std::uint32_t> start_;    // of each target in the leaf
    std::size_t new_vertices_ = 0, new_slots_ = 0;
    Index first_fresh_node_ = 0;
    Index cap_vertices_ = 0;  // first vertex of the caps: negative side, then positive side
};

}  // namespace kerf::halfedge
