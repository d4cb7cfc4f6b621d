#pragma once

#include <cstddef>
#include <vector>

#include "common/mesh/plane.h"
#include "halfedge/cut/tree_program.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// A node that was met on the way down a tree.
struct NodeVisit
{
    TreeOp op;           ///< what becomes of it
    Index child = 0;     ///< the visit of its left child, which that of the right one follows; 0: none was met
    Index count = 0;     ///< visits in its subtree
    Index first_op = 0;  ///< where the subtree's part of the program begins
};

/// What a walk down a tree has found.
struct TreeVisit
{
    BySide<bool> present{};  ///< whether a part lies wholly on a side
    std::size_t nodes = 0;   ///< that were looked at
};

/// Which parts of a shell's tree a plane meets: appends a program in post-order that hands over what lies on one side,
/// names the leaves whose boxes the plane meets, in the tree's order, and asks for their triangles' memory.
/// O(s log(n / s)) nodes for s such leaves.
///
/// @param shell   its number among the cut shells, for the targets of what is handed over
/// @param visits  scratch; at least kFewVisits of them
TreeVisit visit_tree(const Universe& universe, const Plane& plane, Index shell, NodeId root,
                     std::vector<NodeVisit>& visits, std::vector<TreeOp>& program);

inline constexpr std::size_t kFewVisits = 64;

}  // namespace kerf::core::halfedge
