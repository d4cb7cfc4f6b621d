#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "common/caps/cap_triangulator.h"
#include "common/cutting/cut.h"
#include "common/cutting/cut_geometry.h"
#include "halfedge/universe/universe.h"

// What a cut is planned in. All vectors keep their memory from cut to cut.
//
// What belongs together, from the object to its fragments:
//
//   shell of the object   that the plane meets: a CutShell, with a program of TreeOps that takes its tree apart
//     Target              one side of a cut shell, or a connected part of that side: where triangles go
//       PieceShell        targets that caps or touching edges join: a shell of a fragment
//         fragment        piece shells of one side (or of one piece, if the caller asks for pieces), and whole shells
//
// A Crossing is a triangle that the plane cuts, an outline edge one of its section edges or an edge in the plane, a
// Loop a closed run of outline edges. Loops that bound the same two piece shells are one set, which caps close
// together.

namespace kerf::halfedge {

/// A triangle with corners strictly on both sides.
struct Crossing
{
    Index slot = kNone, face = kNone, group = kNone;
    Index shell = 0;              ///< which of the cut shells
    std::array<Index, 3> corner;  ///< its vertices
    std::array<double, 3> distance;
    std::array<Index, 3> halfedge;  ///< halfedge[i] leaves corner i; before the cut
    std::array<Index, 3> point;     ///< vertices of the half-edge mesh at the corners; before the cut
    TriangleSplit split;
    bool walked = false;
    BySide<Index> target{};  ///< where what it falls into goes
    /// No triangle is left at the section edge, neither a piece of this one nor what lies beyond. Open meshes
    /// only.
    BySide<bool> bounds_nothing{};

    // The section runs through the triangle from its entry edge (positive to negative corner) to its exit edge
    // (negative to positive), as seen in the positive side's surface. kNone: it runs through an end point of that edge,
    // which stays whole.
    Index entry_cut_point = kNone, exit_cut_point = kNone;
    Index entry_vertex = kNone, exit_vertex = kNone;  ///< vertices at the cut points, where pieces need them

    bool lone_positive() const { return split.lone_side == Side::positive; }
    // In split_triangle()'s terms: N lies on the edge lone -> next, P on previous -> lone.
    Index& n_cut_point() { return lone_positive() ? entry_cut_point : exit_cut_point; }
    Index& p_cut_point() { return lone_positive() ? exit_cut_point : entry_cut_point; }
    Index n_cut_point() const { return lone_positive() ? entry_cut_point : exit_cut_point; }
    Index p_cut_point() const { return lone_positive() ? exit_cut_point : entry_cut_point; }
    Index n_vertex() const { return lone_positive() ? entry_vertex : exit_vertex; }
    Index p_vertex() const { return lone_positive() ? exit_vertex : entry_vertex; }
    int lone() const { return split.lone; }
    int next() const { return (split.lone + 1) % 3; }
    int previous() const { return (split.lone + 2) % 3; }
};

/// An existing edge in the plane between a face kept on the negative and one kept on the positive side.
struct InPlaneEdge
{
    Index negative_halfedge = kNone, positive_halfedge = kNone;
    Index negative_face = kNone, positive_face = kNone;
    Index group = kNone;
    Index shell = 0;
    Index start_vertex = kNone;  ///< where the positive half-edge starts
    BySide<Index> target{};      ///< where its faces go
};

/// An existing edge in the plane at a face that is kept on the same side as the face across it.
struct FlushEdge
{
    Index halfedge = kNone, face = kNone;
    Side side = Side::negative;
    Index target = kNone;
};

/// A step of the program that rebuilds a tree, in post-order: FIND writes it, REBUILD runs it once.
struct TreeOp
{
    enum class Kind : std::uint8_t
    {
        whole,  ///< hand over subtree `node` to target `argument`
        leaf,   ///< rewrite leaf `node`; its entries start at `argument`
        join,   ///< combine the results of the two children of inner node `node`
    };
    Kind kind;
    Index node;
    Index argument;
};

/// Where a triangle of a rewritten leaf goes: to a target, or to several as a crossing triangle.
class LeafEntry
{
public:
    LeafEntry() = default;
    static LeafEntry to_target(Index target) { return LeafEntry(target); }
    static LeafEntry to_crossing(Index crossing) { return LeafEntry(kCrossing + crossing); }

    bool is_crossing() const { return (number_ & kCrossing) != 0; }
    Index target() const { return number_; }
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
    std::uint32_t loops = 0;  ///< closed loops and chains on it
};

/// The target that a side of a cut shell has before it is known whether the side falls apart.
inline Index first_target(Index shell, Side side)
{
    return 2 * shell + static_cast<Index>(side);
}

/// The side of such a target.
inline Side side_of_target(Index first_target)
{
    return static_cast<Side>(first_target % 2);
}

/// A connected part of one side of a cut shell: where triangles go. Each side of each cut shell has a first_target();
/// if a side falls apart there are more behind them.
struct Target
{
    Side side = Side::negative;
    Index shell = 0;           ///< of the cut shells
    bool is_empty = false;     ///< all that would be in it has vanished
    Index piece_shell = 0;     ///< what it is joined with
    std::uint32_t count = 0;   ///< rewritten triangles
    std::uint32_t cursor = 0;  ///< next slot to write
    std::uint32_t leaves = 0;  ///< rewritten leaves that it has a part in
    Index root = kNone;
};

/// Targets of one piece: a shell of a fragment.
struct PieceShell
{
    Side side = Side::negative;
    std::uint32_t solid = 0;
    Index shell = 0;     ///< the first of the cut shells in it
    Index fragment = 0;  ///< index in the side's fragments
    bool connected = true;
    Index root = kNone;
    Index cap_group = kNone;  ///< the draw group of its caps
    std::uint32_t cap_count = 0, cap_first = 0, cap_cursor = 0;
};

/// An edge of the section's outline: i < crossings is the section edge of crossing triangle i, the ones after it are
/// the in-plane edges.
using OutlineEdgeId = Index;

/// A closed loop of outline edges, or a chain that ends at boundary.
struct Loop
{
    std::size_t first = 0, count = 0;  ///< in `loop_edges` and `loop_points`: outline edge i starts at point i
    std::uint32_t solid = 0;
    Index shell = 0;    ///< of the cut shells
    Index cap_set = 0;  ///< loops of one set are closed together: they bound the same piece shells on both sides
    bool closed = true;
    glm::vec3 end{0.0f};  ///< chains: the end of the last outline edge
};

/// A crossed edge on the boundary of the mesh.
struct BoundaryCut
{
    Index halfedge = kNone;  ///< the boundary half-edge
    Index cut_point = kNone;
    Index positive_end = kNone, negative_end = kNone;  ///< its vertices
};

/// The caps of one set of loops.
struct CapSet
{
    Index set = 0;
    std::size_t first = 0, count = 0;  ///< triangles
};

/// An outline edge between classes of points that coincide.
struct ClassedEdge
{
    OutlineEdgeId id = kNone;
    Index from = 0, to = 0;  ///< in `outline_points`, as it runs in the surface of the positive side
};

class CapPlanner;
class Components;
class Stitcher;
class Rebuilder;

/// A vector whose elements are used again and again without being made anew: add() returns one as it was left.
template <class T>
class Recycled
{
public:
    T& add()
    {
        if (size_ == items_.size()) items_.emplace_back();
        return items_[size_++];
    }
    void clear() { size_ = 0; }
    void reserve(std::size_t count)
    {
        if (items_.size() < count) items_.resize(count);
    }
    std::size_t size() const { return size_; }
    bool empty() const { return size_ == 0; }
    T& operator[](std::size_t i) { return items_[i]; }
    const T& operator[](std::size_t i) const { return items_[i]; }
    auto begin() { return items_.begin(); }
    auto end() { return items_.begin() + static_cast<std::ptrdiff_t>(size_); }
    auto begin() const { return items_.begin(); }
    auto end() const { return items_.begin() + static_cast<std::ptrdiff_t>(size_); }

private:
    std::vector<T> items_;
    std::size_t size_ = 0;
};

struct CutScratch
{
    // FIND
    std::vector<TreeOp> ops;
    std::vector<LeafEntry> entries;
    Recycled<Crossing> crossings;
    std::vector<InPlaneEdge> in_plane;
    std::vector<FlushEdge> flush;
    std::vector<CutShell> cut_shells;
    std::uint64_t nodes_visited = 0;
    std::uint64_t triangles_read = 0;  ///< in leaves that were opened and handed over whole
    std::vector<std::pair<Index, bool>> stack;

    std::uint64_t extra_stamps = 0;  ///< stamps used beyond those of the crossing triangles

    // WALK
    std::vector<glm::vec3> cut_points;  ///< position of each cut edge's point
    std::vector<Index> chain;
    std::vector<BoundaryCut> boundary_cuts;
    std::size_t new_vertices = 0;  ///< written behind the universe's vertices so far
    bool irregular = false;        ///< some cut points coincide with vertices or each other, or edges lie in the plane
    bool collapsed = false;        ///< a cut point fell on a corner off the plane, or on another: pieces vanish
    bool meets_boundary = false;   ///< the section runs through a vertex on the boundary of the mesh
    std::vector<ClassedEdge> outline;       ///< irregular sections: all outline edges that do not cancel
    std::vector<glm::vec3> outline_points;  ///< irregular sections: by class
    /// By cut point: more than one vertex may be there on a side, or it is one with others. What lies there finds its
    /// vertices by going around them; anywhere else a cut point is one vertex on each side.
    std::vector<std::uint8_t> cut_point_is_shared;
    bool any_shared = false;  ///< some point of the outline is shared
    /// Loop by loop, and behind them, once caps are planned, the points where loops cross: those are points of caps
    /// alone, each with an outline edge near by.
    std::vector<Index> loop_edges;
    std::vector<glm::vec3> loop_points;
    std::vector<Loop> loops;
    /// Pairs of outline edges that run forth and back over the same points.
    std::vector<std::array<OutlineEdgeId, 2>> cancelled;

    // CAP
    /// Corners are loop points, counter-clockwise seen from the positive side; outline edges are those of `loop_edges`.
    std::vector<CapTriangle> caps;
    std::vector<CapSet> cap_sets;
    std::vector<Index> cap_order;  ///< of the cap triangles, spatially coherent within a group

    // What goes where
    std::vector<Target> targets;
    std::vector<PieceShell> piece_shells;
    std::vector<BySide<Index>> cap_piece_shell;  ///< of each cap triangle

    /// Says of point p of the outline that it is shared.
    void share_point(std::size_t p)
    {
        any_shared = true;
        const OutlineEdgeId edge = loop_edges[p];
        if (edge < crossings.size() && crossings[edge].entry_cut_point != kNone)
            cut_point_is_shared[crossings[edge].entry_cut_point] = 1;
    }
    /// The same of both ends of an outline edge.
    void share_ends(OutlineEdgeId edge)
    {
        any_shared = true;
        if (edge >= crossings.size()) return;
        for (const Index cut_point : {crossings[edge].entry_cut_point, crossings[edge].exit_cut_point})
            if (cut_point != kNone) cut_point_is_shared[cut_point] = 1;
    }
    bool is_shared(Index cut_point) const { return cut_point == kNone || cut_point_is_shared[cut_point] != 0; }
    /// Whether some corner of a crossing triangle's pieces may be at a shared point.
    bool is_shared(const Crossing& c) const
    {
        return c.split.next_code != TriangleSplit::kCutNext || c.split.previous_code != TriangleSplit::kCutPrevious ||
               is_shared(c.entry_cut_point) || is_shared(c.exit_cut_point);
    }

    // The steps that keep memory of their own
    std::unique_ptr<CapPlanner> cap_planner;
    std::unique_ptr<Components> components;
    std::unique_ptr<Stitcher> stitcher;
    std::unique_ptr<Rebuilder> rebuilder;

    CutScratch();
    ~CutScratch();
    /// Makes room for a cut that crosses so many triangles, and touches it.
    void reserve(std::size_t crossings);
    /// Forgets the last cut.
    void begin(Universe& universe);
    /// Stamps, from the universe's `stamp_base` on, that the last cut has put on faces.
    std::uint64_t stamps_used() const { return crossings.size() + extra_stamps; }

    /// Each curve that the surface is cut along is a loop or chain of the outline. Not so where a curve shrinks to a
    /// point (a thin neck) or to a path run forth and back (a thin sheet), or falls apart at the boundary.
    bool loops_are_all_curves() const { return !collapsed && !meets_boundary && cancelled.empty(); }

    /// The face at an outline edge on one side, as it is before the cut.
    Index face_of(OutlineEdgeId edge, Side side) const
    {
        if (edge < crossings.size()) return crossings[edge].face;
        const InPlaneEdge& e = in_plane[edge - crossings.size()];
        return side == Side::negative ? e.negative_face : e.positive_face;
    }
    Index group_of(OutlineEdgeId edge) const
    {
        return edge < crossings.size() ? crossings[edge].group : in_plane[edge - crossings.size()].group;
    }
    Index shell_of(OutlineEdgeId edge) const
    {
        return edge < crossings.size() ? crossings[edge].shell : in_plane[edge - crossings.size()].shell;
    }
    /// Where what is left of it on that side goes.
    Index target_of(OutlineEdgeId edge, Side side) const
    {
        return edge < crossings.size() ? crossings[edge].target[side] : in_plane[edge - crossings.size()].target[side];
    }
    /// The smaller one of its faces' sources: a flipped plane has the same.
    std::uint32_t source_of(const Universe& universe, OutlineEdgeId edge) const
    {
        return std::min(universe.source_of_face[face_of(edge, Side::negative)],
                        universe.source_of_face[face_of(edge, Side::positive)]);
    }
    bool bounds_nothing(OutlineEdgeId edge, Side side) const
    {
        return edge < crossings.size() && crossings[edge].bounds_nothing[side];
    }
    /// The piece shells that an outline edge lies between.
    BySide<Index> piece_shells_of(OutlineEdgeId edge) const
    {
        return {targets[target_of(edge, Side::negative)].piece_shell,
                targets[target_of(edge, Side::positive)].piece_shell};
    }

private:
    void clear();
};

/// FIND for one shell: appends its program, crossing triangles and in-plane edges. `shell_index` numbers the cut
/// shells; targets are 2 * shell_index + side. Returns which sides keep whole triangles; crossing triangles count for
/// both.
BySide<bool> find(Universe& universe, Index root, const Plane& plane, Index shell_index, CutScratch& scratch);

/// SPLIT and WALK: splits the crossing triangles, makes the new vertices and links the outline into loops and chains.
void split_crossings(const Universe& universe, CutScratch& scratch);
void walk_section(Universe& universe, const Plane& plane, CutScratch& scratch);

}  // namespace kerf::halfedge
