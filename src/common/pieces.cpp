#include "common/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/disjoint_sets.h"
#include "common/nesting.h"

namespace kerf {

namespace {

/// The axis along which the plane's normal is longest: leaving it out projects the plane without loss, and a ray along
/// it gets away from the plane fastest.
int dominant_axis(const Plane& plane)
{
    const glm::dvec3 size = glm::abs(plane.normal);
    return size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
}

/// A section loop in the plane of the two other axes.
struct FlatLoop
{
    std::uint32_t part = 0;
    double area2 = 0.0;  ///< twice the area, positive for an outer loop
    Box box;             ///< z = 0
    std::vector<PlanarPoint> points;
};

FlatLoop flatten(const PartLoop& loop, int axis, bool mirrored)
{
    FlatLoop flat;
    flat.part = loop.part;
    flat.points.reserve(loop.points.size());
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const glm::vec3& p : loop.points) {
        flat.points.push_back({p[u], p[v]});
        flat.box.add(glm::vec3(p[u], p[v], 0.0f));
    }
    for (std::size_t i = 0; i + 2 < flat.points.size(); ++i) {
        // About the first point, so that a loop far from the origin loses no digits.
        const PlanarPoint &o = flat.points[0], &p = flat.points[i + 1], &q = flat.points[i + 2];
        flat.area2 += (double(p.u) - double(o.u)) * (double(q.v) - double(o.v)) -
                      (double(p.v) - double(o.v)) * (double(q.u) - double(o.u));
    }
    if (mirrored) flat.area2 = -flat.area2;
    return flat;
}

/// Calls visit(p, q) for each edge of a loop.
template <class Visit>
void for_each_edge(const FlatLoop& loop, Visit&& visit)
{
    for (std::size_t i = 0; i < loop.points.size(); ++i)
        visit(loop.points[i], loop.points[i + 1 < loop.points.size() ? i + 1 : 0]);
}

/// The middle of the longest way through the inside of the loop at height v; false when there is none.
bool middle_at(const FlatLoop& loop, float v, glm::vec3& middle)
{
    std::vector<std::pair<double, int>> hits;  // u, winding
    for_each_edge(loop, [&](const PlanarPoint& p, const PlanarPoint& q) {
        if ((p.v <= v) == (q.v <= v)) return;
        const double t = (double(v) - double(p.v)) / (double(q.v) - double(p.v));
        hits.emplace_back(double(p.u) + t * (double(q.u) - double(p.u)), p.v <= v ? 1 : -1);
    });
    std::sort(hits.begin(), hits.end());
    int winding = 0;
    double longest = 0.0;
    for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
        winding += hits[i].second;
        const double length = hits[i + 1].first - hits[i].first;
        if (winding == 0 || length <= longest) continue;
        longest = length;
        middle = {static_cast<float>(hits[i].first + length / 2), v, 0.0f};
    }
    return longest > 0.0;
}

/// Three points in a loop, each at a height where no point of the loop is near: loops may touch one another in points
/// and edges, but hardly there.
void add_samples(const FlatLoop& loop, std::uint32_t candidate, std::vector<NestingSample>& samples)
{
    constexpr std::size_t kSamples = 3;  // odd, so that they always have a majority
    std::vector<float> heights;
    heights.reserve(loop.points.size());
    for (const PlanarPoint& p : loop.points) heights.push_back(p.v);
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());

    const std::size_t gaps = heights.size() - 1;
    for (std::size_t part = 0; part < kSamples; ++part) {
        // The widest gap in each third of the heights.
        const std::size_t begin = gaps * part / kSamples, end = std::max(begin + 1, gaps * (part + 1) / kSamples);
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
    std::vector<NestingSample> samples;
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

/// Joins each hole of one solid with the smallest outer loop around it.
void join_holes(std::span<const FlatLoop> loops, DisjointSets& pieces)
{
    std::vector<Nestable> items;
    items.reserve(loops.size());
    for (const FlatLoop& loop : loops)
        items.push_back({loop.box, std::abs(loop.area2), loop.area2 > 0.0, loop.area2 < 0.0});
    const std::vector<std::uint32_t> container = smallest_containers(
        items, [&](auto outer, auto candidates, auto lies_in) { decide(loops, outer, candidates, lies_in); });
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (container[i] != kNoContainer) pieces.unite(loops[i].part, loops[container[i]].part);
}

/// The parts of one solid.
struct SolidParts
{
    std::vector<std::uint32_t> shown;     ///< cut parts, and whole shells that are no cavities
    std::vector<std::uint32_t> cavities;  ///< whole shells of negative volume
    bool is_cut = false;
};

/// Joins each cavity of a solid with the piece it lies in.
void join_cavities(const SolidParts& solid, std::span<const SurfacePart> parts, const AxisRay& direction,
                   const CountCrossings& count_crossings, DisjointSets& pieces)
{
    if (solid.cavities.empty() || solid.shown.empty()) return;
    // Parts by piece, pieces in the order of their first part. Cavities are not among them: joining one changes nothing
    // here.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> by_piece;
    for (const std::uint32_t part : solid.shown) by_piece.emplace_back(pieces.find(part), part);
    std::sort(by_piece.begin(), by_piece.end());
    const bool is_one = by_piece.front().first == by_piece.back().first;

    for (const std::uint32_t cavity : solid.cavities) {
        // A cavity that no count claims - it touches the surface around it - must be somewhere: in the first piece.
        std::uint32_t home = by_piece.front().second;
        AxisRay ray = direction;
        ray.origin = parts[cavity].sample;
        for (std::size_t i = 0; i < by_piece.size() && !is_one;) {
            const std::size_t first = i;
            int winding = 0;
            for (; i < by_piece.size() && by_piece[i].first == by_piece[first].first; ++i)
                winding += count_crossings(by_piece[i].second, ray);
            if (winding == 0) continue;
            home = by_piece[first].second;
            break;
        }
        pieces.unite(cavity, home);
    }
}

std::vector<std::uint32_t> numbered(DisjointSets& pieces, std::size_t part_count)
{
    // A set's representative is its smallest part, so it is met first.
    std::vector<std::uint32_t> number(part_count);
    std::uint32_t count = 0;
    for (std::uint32_t part = 0; part < part_count; ++part) {
        const std::uint32_t first = pieces.find(part);
        number[part] = first == part ? count++ : number[first];
    }
    return number;
}

/// Dense numbers for the solids that occur, in the order of their first part.
std::vector<std::uint32_t> dense_solids(std::span<const SurfacePart> parts, std::size_t& count)
{
    std::vector<std::uint32_t> ids;
    for (const SurfacePart& part : parts) ids.push_back(part.solid);
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
    count = ids.size();
    std::vector<std::uint32_t> dense;
    for (const SurfacePart& part : parts)
        dense.push_back(static_cast<std::uint32_t>(std::lower_bound(ids.begin(), ids.end(), part.solid) - ids.begin()));
    return dense;
}

}  // namespace

std::vector<std::uint32_t> group_pieces(const Plane& plane, Side side, std::span<const SurfacePart> parts,
                                        std::span<const PartLoop> loops, const CountCrossings& count_crossings)
{
    DisjointSets pieces(static_cast<std::uint32_t>(parts.size()));
    std::size_t solid_count = 0;
    const std::vector<std::uint32_t> solid_of = dense_solids(parts, solid_count);
    std::vector<SolidParts> solids(solid_count);
    for (std::uint32_t part = 0; part < parts.size(); ++part) {
        SolidParts& solid = solids[solid_of[part]];
        const bool is_cavity = !parts[part].is_cut && parts[part].volume6 < 0.0;
        (is_cavity ? solid.cavities : solid.shown).push_back(part);
        solid.is_cut = solid.is_cut || parts[part].is_cut;
    }

    const int axis = dominant_axis(plane);
    const bool ascending = plane.normal[axis] > 0.0;
    std::vector<std::vector<FlatLoop>> flat(solid_count);
    for (const PartLoop& loop : loops)
        if (loop.points.size() > 2) flat[solid_of[loop.part]].push_back(flatten(loop, axis, !ascending));

    const AxisRay away{{}, axis, ascending == (side == Side::positive)};
    for (std::size_t s = 0; s < solid_count; ++s) {
        if (solids[s].is_cut) {
            join_holes(flat[s], pieces);
            join_cavities(solids[s], parts, away, count_crossings, pieces);
        } else {
            const std::uint32_t first = (solids[s].shown.empty() ? solids[s].cavities : solids[s].shown).front();
            for (const auto* some : {&solids[s].shown, &solids[s].cavities})
                for (const std::uint32_t part : *some) pieces.unite(first, part);
        }
    }
    return numbered(pieces, parts.size());
}

}  // namespace kerf
