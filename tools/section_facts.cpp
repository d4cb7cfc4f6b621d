#include "tools/section_facts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace kerf::tools {

namespace {

/// An edge of a loop, projected along a coordinate axis; the left end first.
struct Segment
{
    glm::dvec2 a, b;
    int direction;  ///< +1 when the loop runs to the right, so that the inside is above

    double at(double x) const { return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)); }
};

/// Where two edges cross between the ends of both; not a number when they don't.
double crossing(const Segment& s, const Segment& t)
{
    const double lo = std::max(s.a.x, t.a.x), hi = std::min(s.b.x, t.b.x);
    const double before = s.at(lo) - t.at(lo), behind = s.at(hi) - t.at(hi);
    if (!(lo < hi) || !(before * behind < 0.0)) return std::numeric_limits<double>::quiet_NaN();
    return lo + (hi - lo) * (before / (before - behind));
}

/// Upright edges bound no slab and are left out.
std::vector<Segment> project(std::span<const SectionStep> section, int u, int v)
{
    std::vector<Segment> segments;
    for (const SectionStep& step : section) {
        const glm::dvec3 p(step.from), q(step.to);
        if (p[u] < q[u])
            segments.push_back({{p[u], p[v]}, {q[u], q[v]}, 1});
        else if (q[u] < p[u])
            segments.push_back({{q[u], q[v]}, {p[u], p[v]}, -1});
    }
    std::sort(segments.begin(), segments.end(), [](const Segment& s, const Segment& t) { return s.a.x < t.a.x; });
    return segments;
}

}  // namespace

SectionFacts measure_section(std::span<const Outline> loops, const glm::dvec3& normal)
{
    SectionFacts facts;
    for (const Outline& loop : loops) {
        if (!loop.closed) {
            ++facts.open_chains;
            continue;
        }
        ++facts.loops;
        glm::dvec3 twice{0.0};
        const glm::dvec3 origin(loop.points.front());
        for (std::size_t i = 0; i < loop.points.size(); ++i) {
            const glm::dvec3 a(loop.points[i]), b(loop.points[(i + 1) % loop.points.size()]);
            twice += glm::cross(a - origin, b - origin);
            facts.length += glm::length(b - a);
        }
        facts.area += 0.5 * glm::dot(normal, twice);
    }
    return facts;
}

std::vector<SectionStep> steps_of(std::span<const Outline> loops)
{
    std::vector<SectionStep> steps;
    for (const Outline& loop : loops)
        for (std::size_t i = 0; loop.closed && i < loop.points.size(); ++i)
            steps.push_back({loop.points[i], loop.points[(i + 1) % loop.points.size()]});
    return steps;
}

std::vector<std::vector<SectionStep>> sections_of_solids(const FlatMesh& negative, std::uint32_t cap_material)
{
    struct Edge
    {
        std::uint32_t low, high;  // points
        SectionStep step;
        int direction;
    };
    std::map<std::uint32_t, std::vector<Edge>> edges_of;
    for (const TriangleGroup& group : negative.groups) {
        if (group.kind == TriangleKind::cap && group.material == cap_material) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = negative.triangles[t][i], b = negative.triangles[t][(i + 1) % 3];
                const std::uint32_t p = negative.points[a], q = negative.points[b];
                // A cap runs along the edge the other way.
                edges_of[group.solid].push_back({std::min(p, q),
                                                 std::max(p, q),
                                                 {negative.vertices[b].position, negative.vertices[a].position},
                                                 p < q ? 1 : -1});
            }
    }
    std::vector<std::vector<SectionStep>> sections;
    for (auto& [solid, edges] : edges_of) {
        std::vector<SectionStep>& section = sections.emplace_back();
        std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
            return std::tie(a.low, a.high, a.direction) < std::tie(b.low, b.high, b.direction);
        });
        for (std::size_t first = 0, last = 0; first < edges.size(); first = last) {
            int balance = 0;
            for (; last < edges.size() && edges[last].low == edges[first].low && edges[last].high == edges[first].high;)
                balance += edges[last++].direction;
            // Those that run one way come first, those that run the other way last.
            for (; balance < 0; ++balance) section.push_back(edges[first].step);
            for (; balance > 0; --balance) section.push_back(edges[last - 1].step);
        }
    }
    return sections;
}

std::optional<std::vector<std::vector<SectionStep>>> keep_loops(std::span<const std::vector<SectionStep>> sections,
                                                                std::span<const Outline> loops)
{
    // By where a step leads, how often each section has it.
    std::map<std::array<float, 6>, std::map<std::size_t, std::size_t>> left;
    const auto sections_with = [&](const SectionStep& step) -> std::map<std::size_t, std::size_t>& {
        const glm::vec3 &a = step.from, &b = step.to;
        return left[{a.x, a.y, a.z, b.x, b.y, b.z}];
    };
    for (std::size_t s = 0; s < sections.size(); ++s)
        for (const SectionStep& step : sections[s]) ++sections_with(step)[s];

    std::vector<std::vector<SectionStep>> kept(sections.size());
    for (const Outline& loop : loops) {
        if (!loop.closed) continue;
        const std::vector<SectionStep> steps = steps_of({&loop, 1});
        // The first section that has all of its steps.
        const auto has_loop = [&](std::size_t s) {
            std::size_t taken = 0;
            for (; taken < steps.size(); ++taken) {
                std::map<std::size_t, std::size_t>& counts = sections_with(steps[taken]);
                const auto count = counts.find(s);
                if (count == counts.end() || count->second == 0) break;
                --count->second;
            }
            if (taken == steps.size()) return true;
            while (taken-- > 0) ++sections_with(steps[taken])[s];
            return false;
        };
        const std::map<std::size_t, std::size_t>& candidates = sections_with(steps.front());
        const auto found = std::find_if(candidates.begin(), candidates.end(),
                                        [&](const auto& candidate) { return has_loop(candidate.first); });
        if (found == candidates.end()) return std::nullopt;
        std::vector<SectionStep>& section = kept[found->first];
        section.insert(section.end(), steps.begin(), steps.end());
    }
    return kept;
}

std::optional<WindingFacts> measure_winding(std::span<const SectionStep> section, const glm::dvec3& normal)
{
    // Not dominant_axis(): a judge shares no code with what it judges.
    const glm::dvec3 size = glm::abs(normal);
    const int dropped = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    int u = (dropped + 1) % 3, v = (dropped + 2) % 3;
    if (normal[dropped] < 0.0) std::swap(u, v);

    const std::vector<Segment> segments = project(section, u, v);
    std::uint64_t looks_left = kMostWindingLooks;
    std::vector<double> xs;
    for (std::size_t i = 0; i < segments.size(); ++i) {
        xs.push_back(segments[i].a.x);
        xs.push_back(segments[i].b.x);
        for (std::size_t j = i + 1; j < segments.size() && segments[j].a.x < segments[i].b.x; ++j) {
            if (--looks_left == 0) return std::nullopt;
            if (const double x = crossing(segments[i], segments[j]); !std::isnan(x)) xs.push_back(x);
        }
    }
    std::sort(xs.begin(), xs.end());
    xs.erase(std::unique(xs.begin(), xs.end()), xs.end());

    // Within a slab edges don't cross: from the lowest upwards, each changes the winding number.
    WindingFacts facts;
    std::size_t next = 0;
    std::vector<const Segment*> active;
    for (std::size_t i = 0; i + 1 < xs.size(); ++i) {
        const double left = xs[i], right = xs[i + 1], middle = 0.5 * (left + right);
        std::erase_if(active, [&](const Segment* s) { return s->b.x <= left; });
        for (; next < segments.size() && segments[next].a.x <= left; ++next)
            if (segments[next].b.x > left) active.push_back(&segments[next]);
        if (looks_left <= active.size()) return std::nullopt;
        looks_left -= active.size();
        std::sort(active.begin(), active.end(),
                  [&](const Segment* s, const Segment* t) { return s->at(middle) < t->at(middle); });
        int winding = 0;
        for (std::size_t k = 0; k + 1 < active.size(); ++k) {
            winding += active[k]->direction;
            const double area = (active[k + 1]->at(middle) - active[k]->at(middle)) * (right - left) / size[dropped];
            if (winding < 0) facts.backward -= winding * area;
            if (winding > 1) facts.multiple += area;
        }
    }
    return facts;
}

}  // namespace kerf::tools
