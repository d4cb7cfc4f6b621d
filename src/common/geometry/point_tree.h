#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/mesh/box.h"

namespace kerf::core {

/// A k-d tree over points that finds those in a box and lets points be removed. Building costs O(n log n), a search
/// O(n^(2/3) + k) at worst for k points found and far less for small boxes, removing O(log n).
class PointTree
{
public:
    PointTree() = default;
    explicit PointTree(std::span<const glm::vec3> points) { build(points); }

    /// Begins anew, over points that live as long as the tree is searched. Keeps its memory.
    void build(std::span<const glm::vec3> points);

    /// Calls visit(index) for each remaining point in `box`, borders included.
    template <class Visit>
    void for_each_in(const Box& box, Visit&& visit) const
    {
        search(
            box, [](const Node&) { return false; },
            [&](std::uint32_t index) {
                visit(index);
                return false;
            });
    }

    /// Whether any remaining point lies in `box`, borders included.
    bool any_in(const Box& box) const
    {
        return search(
            box, [&](const Node& node) { return contains(box, node.box.lo) && contains(box, node.box.hi); },
            [](std::uint32_t) { return true; });
    }

    void remove(std::uint32_t index);

private:
    static constexpr std::uint32_t kLeafSize = 8;
    static constexpr std::uint32_t kMaxDepth = 72;  ///< a binary tree over fewer than 2^32 points, both children pushed
    static constexpr std::uint32_t kRemoved = 0xFFFFFFFFu;

    struct Node
    {
        Box box;
        std::uint32_t first = 0, last = 0;  ///< range of order_
        std::uint32_t remaining = 0;
        std::uint32_t child = 0;  ///< the first of two adjacent children; 0 for a leaf
        std::uint32_t parent = 0;
    };

    /// Searches `box` until is_whole(node), asked of each node that has points left and meets the box, or visit(point),
    /// asked of each point in the box, is true. Returns whether one was.
    template <class IsWhole, class Visit>
    bool search(const Box& box, IsWhole is_whole, Visit visit) const
    {
        if (nodes_.empty()) return false;
        std::uint32_t stack[kMaxDepth];
        std::uint32_t depth = 0;
        stack[depth++] = 0;
        while (depth > 0) {
            const Node& node = nodes_[stack[--depth]];
            if (node.remaining == 0 || !overlap(node.box, box)) continue;
            if (is_whole(node)) return true;
            if (node.child != 0) {
                stack[depth++] = node.child + 1;
                stack[depth++] = node.child;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.last; ++i)
                if (leaf_of_[order_[i]] != kRemoved && contains(box, points_[order_[i]]) && visit(order_[i]))
                    return true;
        }
        return false;
    }

    static bool overlap(const Box& a, const Box& b)
    {
        return a.lo.x <= b.hi.x && b.lo.x <= a.hi.x && a.lo.y <= b.hi.y && b.lo.y <= a.hi.y && a.lo.z <= b.hi.z &&
               b.lo.z <= a.hi.z;
    }
    static bool contains(const Box& box, const glm::vec3& p)
    {
        return box.lo.x <= p.x && p.x <= box.hi.x && box.lo.y <= p.y && p.y <= box.hi.y && box.lo.z <= p.z &&
               p.z <= box.hi.z;
    }

    std::span<const glm::vec3> points_;
    std::vector<std::uint32_t> order_;    ///< points by leaf
    std::vector<std::uint32_t> leaf_of_;  ///< node of each point, or kRemoved
    std::vector<Node> nodes_;
};

}  // namespace kerf::core
