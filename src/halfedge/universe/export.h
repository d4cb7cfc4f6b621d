#pragma once

#include <span>

#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// Calls visit(slot) for each slot under a root, in tree order.
template <class Visit>
void for_each_slot(const Universe& universe, NodeId root, Visit visit)
{
    std::vector<NodeId> stack{root};
    while (!stack.empty()) {
        const Node& node = universe.tree.nodes[stack.back()];
        stack.pop_back();
        if (node.is_leaf()) {
            for (SlotId slot = node.first; slot < node.first + node.count; ++slot) visit(slot);
        } else {
            stack.push_back(node.right);
            stack.push_back(node.left);
        }
    }
}

/// A compact copy of some shells: groups in drawing order, vertices and points in the order of their first use. O(n),
/// and memory of the size of the universe unless the shells are a small part of it.
IndexedMesh export_mesh(const Universe& universe, std::span<const ShellRoot> shells);

}  // namespace kerf::core::halfedge
