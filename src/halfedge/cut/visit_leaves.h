#pragma once

#include <cstddef>
#include <vector>

#include "common/mesh/plane.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// A node that was met on the way down a tree, by who only looks.
struct LeafVisit
{
    NodeId node;
    Index child = 0;   ///< the visit of its left child, which that of the right one follows; 0: none was met
    Index leaves = 0;  ///< in its subtree, of those that the plane meets
    Index first = 0;   ///< where they begin in the list
    bool is_leaf = false;
};

/// Appends the leaves of a tree whose boxes the plane meets, in the tree's order, and asks for their triangles' corners:
/// visit_tree() without what a cut needs besides. Returns how many nodes were looked at. O(s log(n / s)) for s leaves.
///
/// @param visits  scratch
std::size_t visit_leaves(const Universe& universe, const Plane& plane, NodeId root, std::vector<LeafVisit>& visits,
                         std::vector<NodeId>& leaves);

}  // namespace kerf::core::halfedge
