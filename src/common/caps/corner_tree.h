#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "common/caps/loop_boxes.h"
#include "common/mesh/four_floats.h"

// A tree over corners along a loop, to find those in a box.

namespace kerf::core {

/// Corners in runs of eight, and boxes above, four side by side: neighbours in a loop are close, so its own order is a good
/// tree. Places are rounded to floats. Rounding keeps their order, so no corner in a box is missed, and one beside it may be
/// found.
class CornerTree
{
public:
    /// So many items, which are nowhere yet. O(count).
    void clear(std::size_t count);
    /// Where an item is.
    void put(std::size_t item, const glm::dvec2& place)
    {
        x_[item] = static_cast<float>(place.x);
        y_[item] = static_cast<float>(place.y);
    }
    /// When the items are where they are. O(count).
    void build();

    /// Calls visit(i) for items in `box` until it returns true. Returns whether it did, or `looks_left` is used up: each item
    /// of a run that the box meets is a look.
    template <class Visit>
    bool any(const Box2& box, std::uint64_t& looks_left, Visit visit) const
    {
        const Window window(box);
        if (levels_ == 0) return !x_.empty() && any_of_run(0, window, looks_left, visit);
        struct Place
        {
            std::size_t level, quad;
        };
        std::array<Place, kLanes * kMostLevels> stack;
        std::size_t depth = 0;
        stack[depth++] = {levels_ - 1, 0};
        while (depth > 0) {
            const auto [level, quad] = stack[--depth];
            for (unsigned lanes = window.met_by(quads_[first_quad_[level] + quad]); lanes != 0; lanes &= lanes - 1) {
                const std::size_t below = kLanes * quad + static_cast<std::size_t>(std::countr_zero(lanes));
                if (level > 0)
                    stack[depth++] = {level - 1, below};
                else if (any_of_run(below, window, looks_left, visit))
                    return true;
            }
        }
        return false;
    }

private:
    static constexpr std::size_t kRun = 2 * kLanes;
    static constexpr std::size_t kMostLevels = 16;  // four to the power of it: more runs than a loop has

    /// Four boxes; not a number where there is none.
    struct Quad
    {
        Quad();
        void set(std::size_t lane, const std::array<float, 4>& box)
        {
            lo_x[lane] = box[0];
            lo_y[lane] = box[1];
            hi_x[lane] = box[2];
            hi_y[lane] = box[3];
        }
        std::array<float, kLanes> lo_x, lo_y, hi_x, hi_y;
    };

    /// A box, in each of four lanes.
    struct Window
    {
        explicit Window(const Box2& box)
            : lo_x(Four{} + static_cast<float>(box.lo_x)),
              lo_y(Four{} + static_cast<float>(box.lo_y)),
              hi_x(Four{} + static_cast<float>(box.hi_x)),
              hi_y(Four{} + static_cast<float>(box.hi_y))
        {
        }
        unsigned met_by(const Quad& q) const
        {
            return lanes_of((load(q.lo_x.data()) <= hi_x) & (lo_x <= load(q.hi_x.data())) &
                            (load(q.lo_y.data()) <= hi_y) & (lo_y <= load(q.hi_y.data())));
        }
        unsigned holds(const float* x, const float* y) const
        {
            return lanes_of((load(x) <= hi_x) & (lo_x <= load(x)) & (load(y) <= hi_y) & (lo_y <= load(y)));
        }
        Four lo_x, lo_y, hi_x, hi_y;
    };

    template <class Visit>
    bool any_of_run(std::size_t run, const Window& window, std::uint64_t& looks_left, const Visit& visit) const
    {
        if (looks_left < kRun) {
            looks_left = 0;
            return true;
        }
        looks_left -= kRun;
        const std::size_t first = run * kRun;
        unsigned inside = window.holds(&x_[first], &y_[first]);
        inside |= window.holds(&x_[first + kLanes], &y_[first + kLanes]) << kLanes;
        for (; inside != 0; inside &= inside - 1)
            if (visit(first + static_cast<std::size_t>(std::countr_zero(inside)))) return true;
        return false;
    }

    std::vector<float> x_, y_;  ///< of the items, in whole runs; not a number if nowhere
    std::vector<Quad> quads_;   ///< level by level, those around runs first
    std::array<std::size_t, kMostLevels> first_quad_{};
    std::size_t levels_ = 0;
};

}  // namespace kerf::core
