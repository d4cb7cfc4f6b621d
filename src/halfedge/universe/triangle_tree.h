#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/box.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/plane.h"
#include "common/mesh/support_points.h"
#include "halfedge/universe/append_buffer.h"
#include "halfedge/universe/surface_mesh.h"

// A persistent binary tree over runs of triangles. Nodes never change once they are made, so fragments share them: a
// cut makes new nodes only where the plane passes and refers to all others.

namespace kerf::core::halfedge {

/// Triangles per leaf: more make a smaller tree, fewer leave less to rewrite around the section. The optimum is flat.
inline constexpr std::uint32_t kLeafTriangles = 32;
/// A rewritten leaf is divided from here on, and small rewritten neighbours are joined up to here.
inline constexpr std::uint32_t kMaxLeafTriangles = 48;
/// The mass of an object of so few triangles is summed when it is asked for: far from the universe's centre the sums of
/// its tree have lost digits to cancellation. So its cuts don't sum any.
inline constexpr std::uint64_t kFewForMass = 4096;

struct Node
{
    Box box;
    NodeId left, right;        ///< none: a leaf
    SlotId first = SlotId(0);  ///< of the run; meaningless if mixed
    std::uint32_t count = 0;   ///< triangles in the subtree
    GroupId group;  ///< of all triangles, if they are of one group and lie in one run of slots; otherwise none

    bool is_leaf() const { return !left.is_valid(); }
    bool is_mixed() const { return !group.is_valid(); }
};

/// Largest support_value() over a subtree for each of the fixed directions.
struct alignas(16) Support
{
    std::array<float, kSupportDirections> best;

    static Support none();
    void add(const glm::vec3& p);
    void add(const Support& other);
    /// The box of what was added: the axes are among the directions, and along them the support value is the
    /// coordinate.
    Box box() const;
};

/// The universe's arrays, from which leaves are computed.
struct TreeGeometry
{
    std::span<const Vertex> vertices;
    std::span<const Triangle> slots;
    const Triangle& triangle(SlotId slot) const { return slots[slot.number()]; }
    /// Whether asking for memory early can pay: smaller arrays stay in the caches of a processor's core.
    bool is_far_away() const
    {
        constexpr std::size_t kNear = 32768;  // triangles, of some 130 bytes
        return slots.size() > kNear;
    }
    glm::dvec3 reference{0.0};   ///< the point that mass moments are summed about
    bool moments_wanted = true;  ///< otherwise those of new leaves are unknown
};

/// The pool of nodes of a universe.
struct TriangleTree
{
    AppendBuffer<Node, NodeId> nodes;
    AppendBuffer<MassMoments, NodeId> moments;
    AppendBuffer<Support, NodeId> supports;

    /// The following need room in the pool (reserve(), make_room()) and can't fail.

    /// A leaf over `count` slots from `first`, all of one group.
    NodeId make_leaf(const TreeGeometry& geometry, SlotId first, std::uint32_t count, GroupId group);
    /// A subtree over a run of slots of one group, in leaves of at most kLeafTriangles. `before_leaf(end)` is called
    /// before the slots in front of `end` are read.
    template <class BeforeLeaf>
    NodeId make_run(const TreeGeometry& geometry, SlotId first, std::uint32_t count, GroupId group,
                    const BeforeLeaf& before_leaf)
    {
        if (count == 0) return {};
        if (count <= kLeafTriangles) {
            before_leaf(first + count);
            return make_leaf(geometry, first, count, group);
        }
        // Halve the number of leaves, so that all but the last are full.
        const std::uint32_t leaves = (count + kLeafTriangles - 1) / kLeafTriangles;
        const std::uint32_t half = (leaves / 2) * kLeafTriangles;
        const NodeId left = make_run(geometry, first, half, group, before_leaf);
        const NodeId right = make_run(geometry, first + half, count - half, group, before_leaf);
        return join(left, right);
    }
    NodeId make_run(const TreeGeometry& geometry, SlotId first, std::uint32_t count, GroupId group)
    {
        return make_run(geometry, first, count, group, [](SlotId) {});
    }
    /// The parent of two subtrees; either may be none, then it is the other one.
    NodeId join(NodeId left, NodeId right);
    /// Makes leaf `left` hold the triangles of leaf `right` too, which follow its own. Only for nodes that no fragment
    /// refers to yet.
    NodeId merge_leaves(NodeId left, NodeId right);

    /// The nodes that make_run() needs, whose leaves are full but for the last.
    static std::size_t nodes_of_full_leaves(std::size_t count)
    {
        return count == 0 ? 0 : 2 * ((count - 1) / kLeafTriangles) + 1;
    }

    /// Asks for the memory that join() will read.
    void prefetch(NodeId node) const
    {
        prefetch_support(node);
        __builtin_prefetch(&moments[node]);
        __builtin_prefetch(reinterpret_cast<const char*>(&moments[node]) + 64);
    }
    /// The same without the moments.
    void prefetch_support(NodeId node) const
    {
        __builtin_prefetch(&nodes[node]);
        __builtin_prefetch(reinterpret_cast<const char*>(&nodes[node] + 1) - 1);
        __builtin_prefetch(&supports[node]);
        __builtin_prefetch(reinterpret_cast<const char*>(&supports[node]) + 64);
    }

    /// As AppendBuffer's.
    void reserve(std::size_t count, std::size_t written_soon = 0);
    std::size_t make_room(std::size_t count);
    std::size_t bytes_reserved() const;

    NodeId last() const { return NodeId(static_cast<Index>(nodes.size() - 1)); }

    /// Maximal runs of slots of one group under `root`, in tree order.
    struct Run
    {
        SlotId first;
        std::uint32_t count;
        GroupId group;
    };
    void append_runs(NodeId root, std::vector<Run>& runs) const;
};

/// True if some vertex under `root` has a signed distance > `limit` (sign = +1) or < -limit (sign = -1). O(log n) on
/// ordinary shapes: the side that reaches farther is searched first. Adds the nodes that it looks at to `visited`.
/// `waiting` is for nodes that wait meanwhile.
bool reaches_beyond(const TriangleTree& tree, const TreeGeometry& geometry, NodeId root, const Plane& plane,
                    double limit, int sign, std::vector<NodeId>& waiting, std::uint64_t& visited);

}  // namespace kerf::core::halfedge
