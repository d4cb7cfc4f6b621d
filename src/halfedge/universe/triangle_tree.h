#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/box.h"
#include "common/mesh/mass_properties.h"
#include "common/mesh/plane.h"
#include "common/proxy/collision_proxy.h"
#include "halfedge/universe/append_buffer.h"
#include "halfedge/universe/surface_mesh.h"

// A persistent binary tree over runs of triangles. Nodes never change once they are made, so fragments share them: a
// cut makes new nodes only where the plane passes and refers to all others.

namespace kerf::halfedge {

/// Triangles per leaf: more make a smaller tree, fewer leave less to rewrite around the section. The optimum is flat.
inline constexpr std::uint32_t kLeafTriangles = 32;
/// A rewritten leaf is divided from here on, and small rewritten neighbours are joined up to here.
inline constexpr std::uint32_t kMaxLeafTriangles = 48;

/// Group of a subtree whose triangles differ in their group or don't lie in one run.
inline constexpr Index kMixed = kNone;

struct Node
{
    Box box;
    Index left = kNone, right = kNone;  ///< kNone: a leaf
    std::uint32_t first = 0;            ///< first slot of the run; meaningless if mixed
    std::uint32_t count = 0;            ///< triangles in the subtree
    Index group = kMixed;               ///< the group of all triangles, if they lie in one run of slots

    bool is_leaf() const { return left == kNone; }
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
    glm::dvec3 reference{0.0};  ///< the point that mass moments are summed about
};

/// The pool of nodes of a universe.
struct TriangleTree
{
    AppendBuffer<Node> nodes;
    AppendBuffer<MassMoments> moments;
    AppendBuffer<Support> supports;

    /// The following need room in the pool (reserve(), make_room()) and can't fail.

    /// A leaf over `count` slots from `first`, all of one group.
    Index make_leaf(const TreeGeometry& geometry, std::uint32_t first, std::uint32_t count, Index group);
    /// A subtree over a run of slots of one group, in leaves of at most kLeafTriangles.
    Index make_run(const TreeGeometry& geometry, std::uint32_t first, std::uint32_t count, Index group);
    /// The parent of two subtrees; either may be kNone, then it is the other one.
    Index join(Index left, Index right);
    /// Makes leaf `left` hold the triangles of leaf `right` too, which follow its own. Only for nodes that no fragment
    /// refers to yet.
    Index merge_leaves(Index left, Index right);

    /// Upper bound on the nodes that make_run() needs.
    static std::size_t nodes_for_run(std::size_t count)
    {
        return count == 0 ? 0 : 2 * ((count - 1) / (kLeafTriangles / 2) + 1);
    }

    /// Asks for the memory that join() will read.
    void prefetch(Index node) const
    {
        __builtin_prefetch(&moments[node]);
        __builtin_prefetch(reinterpret_cast<const char*>(&moments[node]) + 64);
        __builtin_prefetch(&supports[node]);
        __builtin_prefetch(reinterpret_cast<const char*>(&supports[node]) + 64);
    }

    void reserve(std::size_t count);
    std::size_t make_room(std::size_t count);
    std::size_t bytes_reserved() const;

    /// Maximal runs of slots of one group under `root`, in tree order.
    struct Run
    {
        std::uint32_t first, count;
        Index group;
    };
    void append_runs(Index root, std::vector<Run>& runs) const;
};

/// True if some vertex under `root` has a signed distance > `limit` (sign = +1) or < -limit (sign = -1). O(log n) on
/// ordinary shapes: the side that reaches farther is searched first. Adds the nodes that it looks at to `visited`.
bool reaches_beyond(const TriangleTree& tree, const TreeGeometry& geometry, Index root, const Plane& plane,
                    double limit, int sign, std::uint64_t& visited);

/// For each support direction the extreme vertex under `roots`, as support_points() defines it.
std::array<glm::vec3, kSupportDirections> support_points(const TriangleTree& tree, const TreeGeometry& geometry,
                                                         std::span<const Index> roots);

}  // namespace kerf::halfedge
