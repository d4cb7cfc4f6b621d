#pragma once

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace kerf {

/// Which cut points of one cut are the same point of the surface. split_triangle() says so for one triangle at a time;
/// this is the transitive closure over all of them. A class holds at most one point that existed before the cut: two of
/// those are never merged, because triangles that the plane does not touch refer to them. Union-find with path halving;
/// amortised nearly O(1) an operation.
class CutPointClasses
{
public:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    /// A new cut point in a class of its own; ids count up from 0.
    std::uint32_t add()
    {
        const auto id = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({id, kNone});
        return id;
    }

    /// The id that stands for the class of cut point `id`: its smallest.
    std::uint32_t find(std::uint32_t id)
    {
        while (nodes_[id].parent != id) id = nodes_[id].parent = nodes_[nodes_[id].parent].parent;
        return id;
    }

    /// Cut points `a` and `b` are one. No effect when their classes hold different existing points.
    void merge(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        if (a == b) return;
        if (b < a) std::swap(a, b);
        if (nodes_[a].existing != kNone && nodes_[b].existing != kNone && nodes_[a].existing != nodes_[b].existing)
            return;
        if (nodes_[a].existing == kNone) nodes_[a].existing = nodes_[b].existing;
        nodes_[b].parent = a;
    }

    /// Cut point `id` is the existing point `point`. No effect when its class holds another one already.
    void attach(std::uint32_t id, std::uint32_t point)
    {
        std::uint32_t& existing = nodes_[find(id)].existing;
        if (existing == kNone) existing = point;
    }

    /// The existing point in the class of `id`, or kNone.
    std::uint32_t existing(std::uint32_t id) { return nodes_[find(id)].existing; }

    std::size_t size() const { return nodes_.size(); }
    void clear() { nodes_.clear(); }
    void reserve(std::size_t count) { nodes_.reserve(count); }

private:
    struct Node
    {
        std::uint32_t parent;
        std::uint32_t existing;  ///< meaningful at the root of a class
    };
    std::vector<Node> nodes_;
};

}  // namespace kerf
