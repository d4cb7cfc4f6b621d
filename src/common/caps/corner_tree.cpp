#include "common/caps/corner_tree.h"

#include <algorithm>
#include <limits>

namespace kerf::core {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();

// Least and largest of what is somewhere: a comparison with what is not a number keeps the other.

float least(Four a, Four b)
{
    const Four low = smaller(b, smaller(a, Four{} + kInfinity));
    return std::min(std::min(low[0], low[1]), std::min(low[2], low[3]));
}
float largest(Four a, Four b)
{
    const Four high = larger(b, larger(a, Four{} - kInfinity));
    return std::max(std::max(high[0], high[1]), std::max(high[2], high[3]));
}

}  // namespace

CornerTree::Quad::Quad()
{
    for (auto* side : {&lo_x, &lo_y, &hi_x, &hi_y}) side->fill(kNowhere);
}

void CornerTree::clear(std::size_t count)
{
    const std::size_t whole_runs = (count + kRun - 1) / kRun * kRun;
    x_.assign(whole_runs, kNowhere);
    y_.assign(whole_runs, kNowhere);
}

void CornerTree::build()
{
    quads_.clear();
    levels_ = 0;
    std::size_t boxes = x_.size() / kRun;
    const auto add_level = [&] {
        first_quad_[levels_++] = quads_.size();
        quads_.resize(quads_.size() + (boxes + kLanes - 1) / kLanes);
        return &quads_[first_quad_[levels_ - 1]];
    };
    if (boxes <= 1) return;
    Quad* const around_runs = add_level();
    for (std::size_t run = 0; run < boxes; ++run) {
        const Four x0 = load(&x_[run * kRun]), x1 = load(&x_[run * kRun + kLanes]);
        const Four y0 = load(&y_[run * kRun]), y1 = load(&y_[run * kRun + kLanes]);
        around_runs[run / kLanes].set(run % kLanes, {least(x0, x1), least(y0, y1), largest(x0, x1), largest(y0, y1)});
    }
    while ((boxes = quads_.size() - first_quad_[levels_ - 1]) > 1) {
        Quad* const above = add_level();
        const Quad* const below = &quads_[first_quad_[levels_ - 2]];
        for (std::size_t i = 0; i < boxes; ++i) {
            const Quad& q = below[i];
            const auto four = [](const std::array<float, kLanes>& a) { return load(a.data()); };
            above[i / kLanes].set(i % kLanes,
                                  {least(four(q.lo_x), four(q.lo_x)), least(four(q.lo_y), four(q.lo_y)),
                                   largest(four(q.hi_x), four(q.hi_x)), largest(four(q.hi_y), four(q.hi_y))});
        }
    }
}

}  // namespace kerf::core
