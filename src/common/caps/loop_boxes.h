#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

// A tree of boxes along the edges of a loop, to find those that a box meets.

namespace kerf::core {

/// A box in the plane of a section; initially empty.
struct Box2
{
    double lo_x = std::numeric_limits<double>::infinity(), lo_y = lo_x, hi_x = -lo_x, hi_y = -lo_x;

    void add(double x, double y)
    {
        lo_x = std::min(lo_x, x);
        lo_y = std::min(lo_y, y);
        hi_x = std::max(hi_x, x);
        hi_y = std::max(hi_y, y);
    }
    Box2 joined(const Box2& other) const
    {
        Box2 box;
        box.lo_x = std::min(lo_x, other.lo_x);
        box.lo_y = std::min(lo_y, other.lo_y);
        box.hi_x = std::max(hi_x, other.hi_x);
        box.hi_y = std::max(hi_y, other.hi_y);
        return box;
    }
    bool overlaps(const Box2& other) const
    {
        return lo_x <= other.hi_x && other.lo_x <= hi_x && lo_y <= other.hi_y && other.lo_y <= hi_y;
    }
};

/// Boxes over items along a loop, in runs of eight and pairs of runs above: neighbours in a loop are close, so its own
/// order is a good tree.
class LoopBoxes
{
public:
    /// `add_to(i, box)` adds item i, or nothing, to a box. O(count).
    template <class AddTo>
    void build(std::size_t count, AddTo add_to)
    {
        count_ = count;
        const std::size_t leaves = (count + kRun - 1) / kRun;
        first_leaf_ = 1;
        while (first_leaf_ < leaves) first_leaf_ *= 2;
        boxes_.resize(2 * first_leaf_);
        for (std::size_t leaf = 0; leaf < first_leaf_; ++leaf) {
            Box2 box;
            const std::size_t end = std::min(count, (leaf + 1) * kRun);
            for (std::size_t i = leaf * kRun; i < end; ++i) add_to(i, box);
            boxes_[first_leaf_ + leaf] = box;
        }
        for (std::size_t i = first_leaf_ - 1; i > 0; --i) boxes_[i] = boxes_[2 * i].joined(boxes_[2 * i + 1]);
    }

    /// Calls visit(i) for all items of runs whose box overlaps `box` until it returns true. Returns whether it did.
    template <class Visit>
    bool any(const Box2& box, Visit visit) const
    {
        std::array<std::size_t, 64> stack;
        std::size_t depth = 0;
        stack[depth++] = 1;
        while (depth > 0) {
            const std::size_t n = stack[--depth];
            if (!boxes_[n].overlaps(box)) continue;
            if (n < first_leaf_) {
                stack[depth++] = 2 * n;
                stack[depth++] = 2 * n + 1;
                continue;
            }
            const std::size_t begin = (n - first_leaf_) * kRun, end = std::min(count_, begin + kRun);
            for (std::size_t i = begin; i < end; ++i)
                if (visit(i)) return true;
        }
        return false;
    }

private:
    static constexpr std::size_t kRun = 8;

    std::vector<Box2> boxes_;
    std::size_t count_ = 0, first_leaf_ = 1;
};

}  // namespace kerf::core
