#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/mesh/plane.h"
#include "halfedge/cut/crossing.h"
#include "halfedge/cut/recycled.h"
#include "halfedge/cut/tree_program.h"
#include "halfedge/cut/visit_tree.h"
#include "halfedge/universe/universe.h"

// FIND: which triangles the plane crosses and which parts of the tree go to a side as they are. Result: Found.

namespace kerf::core::halfedge {

/// Where a triangle of a rewritten leaf goes: to a target, or to several as a crossing triangle.
class LeafEntry
{
public:
    LeafEntry() = default;
    static LeafEntry to_target(TargetId target) { return LeafEntry(target.number()); }
    static LeafEntry to_crossing(Index crossing) { return LeafEntry(kCrossing + crossing); }

    bool is_crossing() const { return (number_ & kCrossing) != 0; }
    TargetId target() const { return TargetId(number_); }
    Index crossing() const { return number_ - kCrossing; }

    bool operator==(const LeafEntry&) const = default;

private:
    static constexpr Index kCrossing = Index(1) << 31;

    explicit LeafEntry(Index number) : number_(number) {}

    Index number_ = 0;
};

/// A shell that the plane cuts, and its program.
struct CutShell
{
    Index shell = 0;  ///< index in the object
    std::uint32_t solid = 0;
    bool connected = true;  ///< as ShellRoot
    std::size_t first_op = 0, op_count = 0;
    std::size_t first_crossing = 0, crossing_count = 0;
    std::size_t first_in_plane = 0, in_plane_count = 0;
    std::size_t first_flush = 0, flush_count = 0;
};

/// An edge of the section's outline: the section edge of a crossing triangle, or an edge in the plane. Crossing
/// triangles come first (Found::edge_of_crossing(), edge_in_plane()).
using OutlineEdgeId = Id<struct OutlineEdgeKind>;

/// The result of FIND. Two steps complete it in place, so that nothing is copied: SPLIT and WALK add to each crossing
/// triangle what its comment says, and PartFinder rewrites the programs and the targets if a side falls apart. From the
/// caps on it is only read.
struct Found
{
    BySide<std::vector<ShellRoot>> whole;  ///< shells that the plane does not cut
    std::vector<CutShell> shells;          ///< those that it cuts
    std::vector<TreeOp> ops;
    std::vector<LeafEntry> entries;
    Recycled<Crossing> crossings;
    std::vector<InPlaneEdge> in_plane;
    std::vector<FlushEdge> flush;
    std::uint64_t nodes_visited = 0;
    std::uint64_t triangles_read = 0;  ///< in leaves that were opened and handed over whole

    void reserve(std::size_t crossings_expected);
    void clear();

    /// Whether a side gets any triangle, once the crossing triangles are split.
    bool keeps_triangles(Side side) const;

    std::size_t outline_edge_count() const { return crossings.size() + in_plane.size(); }
    OutlineEdgeId edge_of_crossing(Index number) const { return OutlineEdgeId(number); }
    OutlineEdgeId edge_in_plane(Index number) const
    {
        return OutlineEdgeId(static_cast<Index>(crossings.size()) + number);
    }
    bool is_crossing(OutlineEdgeId edge) const { return edge.number() < crossings.size(); }
    /// The crossing triangle, or the edge in the plane, of an outline edge that is one.
    const Crossing& crossing(OutlineEdgeId edge) const { return crossings[edge.number()]; }
    const InPlaneEdge& in_plane_edge(OutlineEdgeId edge) const { return in_plane[edge.number() - crossings.size()]; }

    /// The face at an outline edge on one side, as it is before the cut.
    FaceId face_of(OutlineEdgeId edge, Side side) const
    {
        if (is_crossing(edge)) return crossing(edge).face;
        const InPlaneEdge& e = in_plane_edge(edge);
        return side == Side::negative ? e.negative_face : e.positive_face;
    }
    GroupId group_of(OutlineEdgeId edge) const
    {
        return is_crossing(edge) ? crossing(edge).group : in_plane_edge(edge).group;
    }
    Index shell_of(OutlineEdgeId edge) const
    {
        return is_crossing(edge) ? crossing(edge).shell : in_plane_edge(edge).shell;
    }
    /// Where what is left of it on that side goes.
    TargetId target_of(OutlineEdgeId edge, Side side) const
    {
        return is_crossing(edge) ? crossing(edge).target[side] : in_plane_edge(edge).target[side];
    }
    /// The smaller one of its faces' sources: a flipped plane has the same.
    std::uint32_t source_of(const Universe& universe, OutlineEdgeId edge) const
    {
        return std::min(universe.source_of_face[face_of(edge, Side::negative)],
                        universe.source_of_face[face_of(edge, Side::positive)]);
    }
    bool bounds_nothing(OutlineEdgeId edge, Side side) const
    {
        return is_crossing(edge) && crossing(edge).bounds_nothing[side];
    }
    bool has_section_edge(OutlineEdgeId edge) const
    {
        return !is_crossing(edge) || crossing(edge).split.has_section_edge();
    }
};

/// What FIND works with, kept for its memory.
struct FindLists
{
    std::vector<NodeVisit> visits;
    std::vector<Index> leaves;  ///< places in the program
};

/// Where an object lies that a plane misses: all of it on one side, or within plane_noise of it on the other. Nothing: the
/// plane may cut it. O(log n) nodes for ordinary shapes, which are added to `nodes_visited`.
/// `waiting` is for nodes that wait meanwhile.
std::optional<Side> missed_side(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane,
                                std::vector<NodeId>& waiting, std::uint64_t& nodes_visited);

/// FIND: which shells and subtrees lie wholly on one side, and which triangles cross the plane. O(s log(n / s)) nodes
/// for s leaves whose box meets the plane.
class Finder
{
public:
    Finder();
    void reserve(std::size_t crossings_expected);
    /// Sorts the shells of an object by what the plane does to them, and writes the programs of those that it cuts.
    /// Numbers the crossing triangles: FaceStamps or FaceTable, cleared. May throw std::bad_alloc.
    template <class Numbers>
    void run(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane, Numbers& numbers,
             Found& found);

private:
    FindLists lists_;
};

}  // namespace kerf::core::halfedge
