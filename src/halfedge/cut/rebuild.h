#pragma once

#include "common/mesh/plane_frame.h"
#include "halfedge/cut/planned_pieces.h"
#include "halfedge/cut/stitch_plan.h"

namespace kerf::core::halfedge {

/// REBUILD: makes the trees and the index buffer of both sides. Subtrees that the plane does not meet are handed over
/// by reference. Leaves that it meets are written anew at the end of the index buffer; each side's new triangles lie in
/// one run there. O(k + s log n) for s leaves that the plane meets.
///
/// plan() may throw std::bad_alloc; run() can't fail.
class Rebuilder
{
public:
    /// Counts what goes where and makes room for it. Returns the bytes grown.
    std::size_t plan(Universe& universe, const Found& found, const Section& section, const Caps& caps, Pieces& pieces);

    /// Writes triangles, vertices of caps and nodes; afterwards the piece shells have their roots.
    ///
    /// @param triangles  of the object that is cut
    /// @param frame      gives the vertices of caps their uv
    void run(Universe& universe, std::uint64_t triangles, const Plane& plane, const PlaneFrame& frame,
             const StitchPlan& numbers, const Found& found, const Section& section, const Caps& caps, Pieces& pieces);

    /// Counts of what run() added.
    std::size_t new_vertices() const { return new_vertices_; }
    std::size_t new_slots() const { return new_slots_; }

private:
    class Ahead;

    /// A target's part of a leaf that is written anew.
    struct LeafPart
    {
        Index leaf = kNone;  ///< the number of its step
        std::uint32_t count = 0;
    };

    /// Counts what a leaf gives to the two sides, or, if they fall apart, to targets.
    ///
    /// @param first_crossing  the first of its crossing triangles
    /// @param number          of the step
    void count_sides(const LeafCounts& counts, Index shell, std::size_t first_crossing, const Found& found,
                     Pieces& pieces);
    void count_targets(const Universe& universe, const TreeOp& op, Index number, const Found& found, Pieces& pieces);
    void write_cap_vertices(Universe& universe, const Plane& plane, const PlaneFrame& frame, const Found& found,
                            const Section& section);
    /// Writes a leaf anew for the two sides, or, if they fall apart, for targets.
    void rewrite_sides(Universe& universe, const TreeOp& op, Index shell, const Ahead& ahead, const StitchPlan& numbers,
                       const Found& found, Pieces& pieces);
    void rewrite_targets(Universe& universe, const TreeOp& op, const Ahead& ahead, const StitchPlan& numbers,
                         const Found& found, Pieces& pieces);
    NodeId make_part(Universe& universe, SlotId first, std::uint32_t count, GroupId group) const;
    void join_results(Universe& universe);
    void write_caps(Universe& universe, const StitchPlan& numbers, std::size_t points, const Caps& caps,
                    Pieces& pieces);

    struct Result
    {
        TargetId target;
        NodeId node;
    };
    std::vector<Result> results_;         // lists of results, one behind the other, each sorted by target
    std::vector<std::uint32_t> lengths_;  // of the lists
    std::vector<TargetId> touched_;       // targets that a leaf has parts in
    std::vector<LeafPart> part_;          // of each target in the last leaf that it has a part in
    std::size_t part_nodes_ = 0;          // at most, of the trees over all parts of leaves, and of what joins them
    std::vector<SlotId> start_;           // of each target in the leaf
    std::size_t new_vertices_ = 0, new_slots_ = 0;
    std::uint64_t triangles_ = 0;  // of the object
    NodeId first_fresh_node_;
    VertexId cap_vertices_;  // first vertex of the caps: negative side, then positive side
};

}  // namespace kerf::core::halfedge
