#include "common/geometry/point_tree.h"

#include <algorithm>
#include <numeric>

#include "common/geometry/dominant_axis.h"

namespace kerf::core {

void PointTree::build(std::span<const glm::vec3> points)
{
    points_ = points;
    order_.resize(points.size());
    leaf_of_.resize(points.size());
    nodes_.clear();
    if (points.empty()) return;
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(points.size() / 2 + 1);
    nodes_.emplace_back().last = static_cast<std::uint32_t>(points.size());
    for (std::uint32_t n = 0; n < nodes_.size(); ++n) {
        const std::uint32_t first = nodes_[n].first, last = nodes_[n].last, middle = first + (last - first) / 2;
        Box& box = nodes_[n].box;
        for (std::uint32_t i = first; i < last; ++i) box.add(points[order_[i]]);
        nodes_[n].remaining = last - first;
        if (last - first <= kLeafSize) {
            for (std::uint32_t i = first; i < last; ++i) leaf_of_[order_[i]] = n;
            continue;
        }
        // Divide the longest side at its median; the index makes the order total, so that equal points divide too.
        const int axis = dominant_axis(glm::dvec3(box.hi) - glm::dvec3(box.lo));
        std::nth_element(order_.begin() + first, order_.begin() + middle, order_.begin() + last,
                         [&](std::uint32_t a, std::uint32_t b) {
                             const float p = points[a][axis], q = points[b][axis];
                             return p != q ? p < q : a < b;
                         });
        const auto child = static_cast<std::uint32_t>(nodes_.size());
        nodes_[n].child = child;
        for (const auto& [from, to] : {std::pair{first, middle}, std::pair{middle, last}}) {
            Node& node = nodes_.emplace_back();
            node.first = from;
            node.last = to;
            node.parent = n;
        }
    }
}

void PointTree::remove(std::uint32_t index)
{
    if (leaf_of_[index] == kRemoved) return;
    std::uint32_t n = leaf_of_[index];
    leaf_of_[index] = kRemoved;
    --nodes_[n].remaining;
    while (n != 0) {
        n = nodes_[n].parent;
        --nodes_[n].remaining;
    }
}

}  // namespace kerf::core
