#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/mesh/index.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"
#include "common/mesh/side.h"

// How the outline of a section is divided into loops and chains, for both back ends: docs/cutting-rules.md, "Loops and
// chains". The result depends on the positions of the outline's points and on the triangles that its edges lie in, not
// on the order in which a back end finds them.

namespace kerf::core {

/// Stands for no part: nothing is left of an edge's triangle on that side (OutlineEdge::part).
inline constexpr std::uint32_t kNoPart = 0xFFFFFFFFu;

/// An edge of a section, as it runs in the surface of the positive side.
struct OutlineEdge
{
    std::uint32_t from = 0, to = 0;    ///< numbers of points
    BySide<std::uint32_t> part{};      ///< the part that it bounds on each side, or kNoPart
    std::uint32_t source = kNoSource;  ///< IndexedMesh::sources of the triangle that it lies in; the smaller of two
};

/// A loop or chain: a run of DividedOutline::edges.
struct OutlinePath
{
    std::size_t first = 0, count = 0;
    bool closed = true;  ///< false: a chain, which ends at the boundary of an open mesh
};

/// An outline taken apart. Each edge is on one path.
struct DividedOutline
{
    std::vector<std::uint32_t> edges;  ///< numbers of edges, path by path; each starts where the one before ends
    std::vector<OutlinePath> paths;
};

/// The only edge at each point, or that there are several.
class EdgeAtPoint
{
public:
    static constexpr std::uint32_t kSeveral = kNone - 1;

    void begin(std::size_t point_count) { edge_.assign(point_count, kNone); }
    void add(std::uint32_t point, std::uint32_t edge) { edge_[point] = edge_[point] == kNone ? edge : kSeveral; }
    /// An edge, kSeveral, or kNone.
    std::uint32_t operator[](std::uint32_t point) const { return edge_[point]; }

private:
    std::vector<std::uint32_t> edge_;
};

/// Finds edges that run forth and back. Keeps its memory.
class OppositeEdges
{
public:
    /// Pairs of edges that run forth and back between two points, as many as there are; each edge is in one pair at
    /// most. Valid until the next call. O(e), and O(d log d) for the d edges at points that several edges leave.
    std::span<const std::array<std::uint32_t, 2>> find(std::size_t point_count, std::span<const OutlineEdge> edges);

private:
    EdgeAtPoint out_;
    std::vector<std::uint32_t> some_;
    std::vector<std::array<std::uint32_t, 2>> pairs_;
};

/// Divides an outline into simple loops and chains: no path visits a point twice. Only edges of one tag follow one
/// another; without tags any may.
///
/// At a point where one edge arrives and one of the same tag leaves there is no choice. Elsewhere the edges that leave
/// are put in order by where they lead (x, y, z), and those that lead to one place by their sources. A path always
/// takes the first that is left; a loop between two visits of a point leaves the path. First come the chains, from the
/// points that more edges leave than arrive at, in the order of their positions; at one position, in the order of the
/// edges there. Then comes the rest, from the same points in the same order. An outline is always followed as seen with
/// the normal's longest component positive, so that a flipped plane divides it alike.
///
/// Loops without a choice come in the order of their first edges, and begin with them. Keeps its memory.
class OutlineDivider
{
public:
    /// Valid until the next call. O(e + d log d) for d edges at points with a choice.
    const DividedOutline& divide(const Plane& plane, std::span<const glm::vec3> points,
                                 std::span<const OutlineEdge> edges, std::span<const std::uint64_t> tags = {});

private:
    /// An edge at a point that is a node.
    struct End
    {
        std::uint32_t point;
        std::uint64_t tag;
        bool arrives;
        std::uint32_t edge;
    };
    /// A point, as seen by the edges of one tag, that these do not just pass: a run of ends_, first those that leave,
    /// then those that arrive.
    struct Node
    {
        std::uint32_t point, first, middle, last;
        std::uint32_t next;           ///< the first end that is not used
        std::uint32_t place = kNone;  ///< where the path has passed

        std::uint32_t leaving() const { return middle - first; }
        std::uint32_t arriving() const { return last - middle; }
    };

    void begin(bool backwards, std::span<const glm::vec3> points, std::span<const OutlineEdge> edges,
               std::span<const std::uint64_t> tags);
    std::uint64_t tag(std::uint32_t edge) const { return tags_.empty() ? 0 : tags_[edge]; }
    bool passes(std::uint32_t point) const;
    const glm::vec3& far_position(const End& end) const;
    int compare_ends(const End& a, const End& b) const;
    void find_nodes();
    bool comes_before(std::uint32_t a, std::uint32_t b) const;
    void follow(std::uint32_t node);
    std::uint32_t follow_strand(std::uint32_t edge);
    void go_round(std::uint32_t first);
    void emit(std::size_t first, bool closed);

    bool backwards_ = false;
    std::span<const glm::vec3> points_;
    std::span<const OutlineEdge> edges_;
    std::span<const std::uint64_t> tags_;
    EdgeAtPoint out_, in_;
    std::vector<std::uint8_t> is_used_;
    std::vector<End> ends_;
    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;   ///< of the nodes
    std::vector<std::uint32_t> head_;    ///< the node that an edge leads to, or kNone
    std::vector<std::uint32_t> path_;    ///< edges
    std::vector<std::uint32_t> passed_;  ///< nodes on the path
    DividedOutline divided_;
};

/// Each of the two, once.
/// @{
std::vector<std::array<std::uint32_t, 2>> opposite_edges(std::size_t point_count, std::span<const OutlineEdge> edges);
DividedOutline divide_outline(const Plane& plane, std::span<const glm::vec3> points, std::span<const OutlineEdge> edges,
                              std::span<const std::uint64_t> tags = {});
/// @}

}  // namespace kerf::core
