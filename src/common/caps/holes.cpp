#include "common/caps/holes.h"

#include <algorithm>
#include <cmath>

#include "common/caps/loop_containment.h"
#include "common/geometry/containment.h"

namespace kerf::core {

namespace {

std::vector<PlanarLoop> outlines_of(std::span<const FlatLoop> loops)
{
    std::vector<PlanarLoop> outlines;
    outlines.reserve(loops.size());
    for (const FlatLoop& loop : loops) outlines.emplace_back(loop.points);
    return outlines;
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
    flat.area2 = twice_area(flat.points, flat.box);
    return flat;
}

void join_holes(std::span<const FlatLoop> loops, DisjointSets& pieces)
{
    std::vector<ContainableShape> items;
    items.reserve(loops.size());
    for (const FlatLoop& loop : loops)
        items.push_back({loop.box, std::abs(loop.area2), loop.area2 > 0.0, loop.area2 < 0.0});
    const std::vector<PlanarLoop> outlines = outlines_of(loops);
    LoopContainment containment;
    containment.begin(outlines);
    const std::vector<std::uint32_t> container = smallest_containers(
        items, [&](auto outer, auto candidates, auto lies_in) { containment.decide(outer, candidates, lies_in); });

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
            containment.decide(*outer, candidates, lies_in);
            for (std::size_t i = 0; i < candidates.size(); ++i)
                if (lies_in[i] != 0) pieces.unite(loops[candidates[i]].part, loops[*outer].part);
        }
        hole = last_hole;
    }
}

}  // namespace kerf::core
