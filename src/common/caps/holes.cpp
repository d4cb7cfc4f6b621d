#include "common/caps/holes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/caps/section_area.h"
#include "common/geometry/containment.h"
#include "common/geometry/line_hits.h"

namespace kerf::core {

namespace {

/// Calls visit(p, q) for each edge of a loop.
template <class Visit>
void for_each_edge(const FlatLoop& loop, Visit&& visit)
{
    for (std::size_t i = 0; i < loop.points.size(); ++i)
        visit(loop.points[i], loop.points[i + 1 < loop.points.size() ? i + 1 : 0]);
}

/// Finds the middle of the longest stretch of inside of the loop at height v. False if there is none.
bool middle_at(const FlatLoop& loop, float v, glm::vec3& middle)
{
    std::vector<LineHit> hits;
    for_each_edge(loop, [&](const PlanarPoint& p, const PlanarPoint& q) {
        if ((p.v <= v) == (q.v <= v)) return;
        const double t = (double(v) - double(p.v)) / (double(q.v) - double(p.v));
        hits.push_back({double(p.u) + t * (double(q.u) - double(p.u)), p.v <= v ? 1 : -1});
    });
    const std::optional<double> u = middle_of_longest_inside(hits);
    if (u) middle = {static_cast<float>(*u), v, 0.0f};
    return u.has_value();
}

/// Adds three interior points of a loop, each at a height where no point of the loop is near: loops may touch one
/// another in points and edges, but hardly there.
void add_samples(const FlatLoop& loop, std::uint32_t candidate, std::vector<WindingSample>& samples)
{
    constexpr std::size_t kSamples = 3;  // odd, so that they always have a majority
    std::vector<float> heights;
    heights.reserve(loop.points.size());
    for (const PlanarPoint& p : loop.points) heights.push_back(p.v);
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());

    const std::size_t gaps = heights.size() - 1;
    for (std::size_t third = 0; third < kSamples; ++third) {
        // The widest gap in each third of the heights.
        const std::size_t begin = gaps * third / kSamples, end = std::max(begin + 1, gaps * (third + 1) / kSamples);
        double widest = 0.0;
        float height = heights[begin];
        for (std::size_t i = begin; i < std::min(end, gaps); ++i) {
            const double gap = double(heights[i + 1]) - double(heights[i]);
            if (gap <= widest) continue;
            widest = gap;
            height = static_cast<float>(double(heights[i]) + gap / 2);
        }
        glm::vec3 middle{loop.points.front().u, loop.points.front().v, 0.0f};
        middle_at(loop, height, middle);
        samples.push_back({middle, candidate});
    }
}

/// Decides which holes (`candidates`) lie in an outer loop.
void decide(std::span<const FlatLoop> loops, std::uint32_t outer, std::span<const std::uint32_t> candidates,
            std::span<std::uint8_t> lies_in)
{
    std::vector<WindingSample> samples;
    for (std::uint32_t i = 0; i < candidates.size(); ++i) add_samples(loops[candidates[i]], i, samples);
    WindingNumbers windings(samples);
    for_each_edge(loops[outer], [&](const PlanarPoint& p, const PlanarPoint& q) {
        Box reach;
        reach.add(glm::vec3(p.u, p.v, 0.0f));
        reach.add(glm::vec3(q.u, q.v, 0.0f));
        reach.lo.x = -std::numeric_limits<float>::infinity();
        windings.add(reach, [&](const glm::vec3& s) { return edge_crossing({s.x, s.y}, p, q); });
    });
    windings.vote(lies_in);
}

}  // namespace

FlatLoop flatten(const SectionOutline& outline, std::span<const std::uint32_t> path, std::uint32_t part, int axis)
{
    FlatLoop flat;
    flat.part = part;
    flat.points.reserve(path.size());
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const std::uint32_t edge : path) {
        const glm::vec3& p = outline.position(outline.edges()[edge].from);
        flat.points.push_back({p[u], p[v]});
        flat.box.add(glm::vec3(p[u], p[v], 0.0f));
    }
    std::rotate(flat.points.begin(),
                std::min_element(flat.points.begin(), flat.points.end(),
                                 [](auto& p, auto& q) { return p.u != q.u ? p.u < q.u : p.v < q.v; }),
                flat.points.end());
    // About a corner of its box, so that a loop far from the origin loses no digits.
    const glm::dvec3 origin(flat.box.lo), size = glm::dvec3(flat.box.hi) - origin;
    OrderlessSum area2(4.0 * (size.x * size.x + size.y * size.y));
    for_each_edge(flat, [&](const PlanarPoint& p, const PlanarPoint& q) {
        area2.add((double(p.u) - origin.x) * (double(q.v) - origin.y) -
                  (double(p.v) - origin.y) * (double(q.u) - origin.x));
    });
    flat.area2 = area2.value();
    return flat;
}

void join_holes(std::span<const FlatLoop> loops, DisjointSets& pieces)
{
    std::vector<ContainableShape> items;
    items.reserve(loops.size());
    for (const FlatLoop& loop : loops)
        items.push_back({loop.box, std::abs(loop.area2), loop.area2 > 0.0, loop.area2 < 0.0});
    const std::vector<std::uint32_t> container = smallest_containers(
        items, [&](auto outer, auto candidates, auto lies_in) { decide(loops, outer, candidates, lies_in); });

    std::vector<std::uint32_t> holes, outer_loops;
    for (std::uint32_t i = 0; i < loops.size(); ++i) {
        if (items[i].can_contain) outer_loops.push_back(i);
        if (container[i] == kNoContainer) continue;
        pieces.unite(loops[i].part, loops[container[i]].part);
        holes.push_back(i);
    }
    const auto size_around = [&](std::uint32_t hole) { return items[container[hole]].size; };
    std::sort(holes.begin(), holes.end(),
              [&](std::uint32_t a, std::uint32_t b) { return size_around(a) < size_around(b); });
    std::sort(outer_loops.begin(), outer_loops.end(),
              [&](std::uint32_t a, std::uint32_t b) { return items[a].size < items[b].size; });
    std::vector<std::uint32_t> candidates;
    std::vector<std::uint8_t> lies_in;
    auto hole = holes.begin();
    for (auto outer = outer_loops.begin(); outer != outer_loops.end();) {
        const double size = items[*outer].size;
        const auto end = std::find_if(outer, outer_loops.end(), [&](std::uint32_t i) { return items[i].size != size; });
        while (hole != holes.end() && size_around(*hole) < size) ++hole;
        const auto last_hole = std::find_if(hole, holes.end(), [&](std::uint32_t i) { return size_around(i) != size; });
        for (; outer != end; ++outer) {
            candidates.clear();
            for (auto i = hole; i != last_hole; ++i)
                if (container[*i] != *outer && encloses(items[*outer].box, items[*i].box)) candidates.push_back(*i);
            if (candidates.empty()) continue;
            lies_in.assign(candidates.size(), 0);
            decide(loops, *outer, candidates, lies_in);
            for (std::size_t i = 0; i < candidates.size(); ++i)
                if (lies_in[i] != 0) pieces.unite(loops[candidates[i]].part, loops[*outer].part);
        }
        hole = last_hole;
    }
}

}  // namespace kerf::core
