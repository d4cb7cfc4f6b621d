#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace kerf {

/// Which cut points of one cut are the same point of the surface. split_triangle() says so for one triangle at a time;
/// this is the transitive closure over all of them, and over points that existed before the cut: if cut points of one
/// class lie on several existing points, these become one. Union-find with path halving; amortised nearly O(1) per
/// operation.
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

    /// Declares cut points `a` and `b` to be one.
    void merge(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        if (a == b) return;
        if (b < a) std::swap(a, b);
        nodes_[b].parent = a;
        if (nodes_[b].existing != kNone) attach(a, nodes_[b].existing);
    }

    /// Declares cut point `id` to be the existing point `point`.
    void attach(std::uint32_t id, std::uint32_t point)
    {
        std::uint32_t& existing = nodes_[find(id)].existing;
        if (existing == kNone)
            existing = point;
        else
            join_existing(existing, point);
    }

    /// The existing point in the class of `id`, or kNone; if there are several, the one that stands for them.
    std::uint32_t existing(std::uint32_t id)
    {
        const std::uint32_t point = nodes_[find(id)].existing;
        return point == kNone ? kNone : standing_for(point);
    }

    /// The existing point that stands for `point`: itself, unless it is one with others.
    std::uint32_t standing_for(std::uint32_t point) const
    {
        for (auto it = joined_.find(point); it != joined_.end(); it = joined_.find(point)) point = it->second;
        return point;
    }

    /// Existing points that others stand for, each with the next one on the way to its stand-in.
    const std::map<std::uint32_t, std::uint32_t>& joined() const { return joined_; }

    std::size_t size() const { return nodes_.size(); }
    void clear()
    {
        nodes_.clear();
        joined_.clear();
    }
    void reserve(std::size_t count) { nodes_.reserve(count); }

private:
    void join_existing(std::uint32_t a, std::uint32_t b)
    {
        a = standing_for(a);
        b = standing_for(b);
        if (a != b) joined_[std::max(a, b)] = std::min(a, b);
    }

    struct Node
    {
        std::uint32_t parent;
        std::uint32_t existing;  ///< meaningful at the root of a class
    };
    std::vector<Node> nodes_;
    std::map<std::uint32_t, std::uint32_t> joined_;  ///< nearly always empty
};

}  // namespace kerf
