#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "common/geometry/disjoint_sets.h"
#include "common/mesh/index.h"

namespace kerf::core {

/// Which cut points of one cut are the same point of the surface. split_triangle() says so for one triangle at a time;
/// this is the transitive closure over all of them, and over points that existed before the cut: if cut points of one
/// class lie on several existing points, these become one. Union-find with path halving; amortised nearly O(1) per
/// operation.
class CutPointClasses
{
public:
    /// A new cut point in a class of its own; ids count up from 0.
    std::uint32_t add()
    {
        existing_.push_back(kNone);
        return classes_.add();
    }

    /// The id that stands for the class of cut point `id`: its smallest.
    std::uint32_t find(std::uint32_t id) { return classes_.find(id); }

    /// Declares cut points `a` and `b` to be one.
    void merge(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        if (a == b) return;
        classes_.unite(a, b);
        const std::uint32_t joins = std::max(a, b);
        if (existing_[joins] != kNone) attach(std::min(a, b), existing_[joins]);
    }

    /// Declares cut point `id` to be the existing point `point`.
    void attach(std::uint32_t id, std::uint32_t point)
    {
        std::uint32_t& existing = existing_[find(id)];
        if (existing == kNone)
            existing = point;
        else
            join_existing(existing, point);
    }

    /// The existing point in the class of `id`, or kNone; if there are several, the one that stands for them.
    std::uint32_t existing(std::uint32_t id)
    {
        const std::uint32_t point = existing_[find(id)];
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

    std::size_t size() const { return existing_.size(); }
    void clear()
    {
        classes_.clear();
        existing_.clear();
        joined_.clear();
    }
    void reserve(std::size_t count)
    {
        classes_.reserve(count);
        existing_.reserve(count);
    }

private:
    void join_existing(std::uint32_t a, std::uint32_t b)
    {
        a = standing_for(a);
        b = standing_for(b);
        if (a != b) joined_[std::max(a, b)] = std::min(a, b);
    }

    DisjointSets classes_{0};
    std::vector<std::uint32_t> existing_;            ///< meaningful at the id that stands for a class
    std::map<std::uint32_t, std::uint32_t> joined_;  ///< nearly always empty
};

}  // namespace kerf::core
