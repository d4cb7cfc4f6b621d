#include "common/caps/loop_containment.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "common/caps/section_area.h"

namespace kerf::core {

namespace {

constexpr std::uint32_t kNotChosen = std::numeric_limits<std::uint32_t>::max();

}  // namespace

double twice_area(PlanarLoop loop, const Box& box)
{
    const glm::dvec3 origin(box.lo), size = glm::dvec3(box.hi) - origin;
    OrderlessSum sum(4.0 * (size.x * size.x + size.y * size.y));
    for_each_edge(loop, [&](const PlanarPoint& p, const PlanarPoint& q) {
        sum.add((double(p.u) - origin.x) * (double(q.v) - origin.y) -
                (double(p.v) - origin.y) * (double(q.u) - origin.x));
    });
    return sum.value();
}

void LoopContainment::begin(std::span<const PlanarLoop> loops)
{
    loops_ = loops;
    first_sample_.assign(loops.size(), kNotChosen);
    chosen_.clear();
}

void LoopContainment::decide(std::uint32_t outer, std::span<const std::uint32_t> candidates,
                             std::span<std::uint8_t> lies_in)
{
    asked_.clear();
    for (std::uint32_t i = 0; i < candidates.size(); ++i)
        for (const glm::vec3& sample : samples_of(candidates[i])) asked_.push_back({sample, i});
    windings_.begin(asked_);
    for_each_edge(loops_[outer], [&](const PlanarPoint& p, const PlanarPoint& q) {
        Box reach;
        reach.add(glm::vec3(p.u, p.v, 0.0f));
        reach.add(glm::vec3(q.u, q.v, 0.0f));
        reach.lo.x = -std::numeric_limits<float>::infinity();
        windings_.add(reach, [&](const glm::vec3& s) { return edge_crossing({s.x, s.y}, p, q); });
    });
    windings_.vote(lies_in);
}

std::span<const glm::vec3> LoopContainment::samples_of(std::uint32_t loop)
{
    if (first_sample_[loop] == kNotChosen) {
        first_sample_[loop] = static_cast<std::uint32_t>(chosen_.size());
        choose_samples(loops_[loop]);
    }
    return std::span(chosen_).subspan(first_sample_[loop], kSamples);
}

/// Each at the middle of the widest gap between heights in its third of them.
void LoopContainment::choose_samples(PlanarLoop loop)
{
    heights_.clear();
    for (const PlanarPoint& p : loop) heights_.push_back(p.v);
    std::sort(heights_.begin(), heights_.end());
    heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());

    const std::size_t gaps = heights_.size() - 1;
    for (std::size_t third = 0; third < kSamples; ++third) {
        const std::size_t begin = gaps * third / kSamples, end = std::max(begin + 1, gaps * (third + 1) / kSamples);
        double widest = 0.0;
        float height = heights_[begin];
        for (std::size_t i = begin; i < std::min(end, gaps); ++i) {
            const double gap = double(heights_[i + 1]) - double(heights_[i]);
            if (gap <= widest) continue;
            widest = gap;
            height = static_cast<float>(double(heights_[i]) + gap / 2);
        }
        glm::vec3 middle{loop.front().u, loop.front().v, 0.0f};
        middle_at(loop, height, middle);
        chosen_.push_back(middle);
    }
}

/// Finds the middle of the longest stretch of inside of the loop at height v. False if there is none.
bool LoopContainment::middle_at(PlanarLoop loop, float v, glm::vec3& middle)
{
    hits_.clear();
    for_each_edge(loop, [&](const PlanarPoint& p, const PlanarPoint& q) {
        if ((p.v <= v) == (q.v <= v)) return;
        const double t = (double(v) - double(p.v)) / (double(q.v) - double(p.v));
        hits_.push_back({double(p.u) + t * (double(q.u) - double(p.u)), p.v <= v ? 1 : -1});
    });
    const std::optional<double> u = middle_of_longest_inside(hits_);
    if (u) middle = {static_cast<float>(*u), v, 0.0f};
    return u.has_value();
}

}  // namespace kerf::core
