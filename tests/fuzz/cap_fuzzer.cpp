// Loops that touch, double back, repeat and cross each other: every way of closing them covers them once and links
// every edge of theirs, or refuses; the last way never refuses.

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "common/caps/clipping_triangulator.h"
#include "common/caps/constrained_triangulator.h"
#include "common/caps/convex_triangulator.h"
#include "common/caps/nested_triangulator.h"
#include "common/caps/topological_triangulator.h"
#include "common/caps/untangling_triangulator.h"
#include "fuzz/byte_reader.h"
#include "fuzz/fuzzers.h"
#include "fuzz/require.h"

namespace kerf::core::fuzz {

namespace {

struct Outline
{
    std::vector<glm::dvec2> points;
    std::vector<glm::vec3> positions;
    std::vector<Index> starts{0};

    CapOutline view() const { return {points, positions, starts}; }
};

/// A few bits at any exponent from that of the least float to 2^64.
float far_coordinate(ByteReader& bytes)
{
    const std::uint8_t bits = bytes.byte();
    const int exponent = static_cast<int>(bytes.below(214)) - 149;
    return std::ldexp(static_cast<float>(static_cast<int>(bits % 16) - 8), exponent) + 0.0f;
}

/// Loops of at least three points, no two consecutive ones at the same place in the projection: what the cap planner
/// hands over.
Outline outline_from(ByteReader& bytes)
{
    Outline outline;
    const std::uint32_t loops = 1 + bytes.below(4);
    for (std::uint32_t l = 0; l < loops; ++l) {
        const std::size_t first = outline.points.size();
        const std::uint32_t size = 3 + bytes.below(30);
        const auto drop = [&] {
            outline.points.pop_back();
            outline.positions.pop_back();
        };
        for (std::uint32_t i = 0; i < size && !bytes.empty(); ++i) {
            glm::vec3 p;
            const std::uint8_t kind = bytes.byte();
            if (kind < 0x40 && !outline.positions.empty()) {
                p = outline.positions[bytes.below(static_cast<std::uint32_t>(outline.positions.size()))];
            } else if (kind >= 0xA0) {
                // Beside a point that is there, by less than rounding of a difference leaves.
                if (kind >= 0xD0 && !outline.positions.empty())
                    p = outline.positions[bytes.below(static_cast<std::uint32_t>(outline.positions.size()))];
                else
                    p = {bytes.coordinate(64), bytes.coordinate(64), 0.0f};
                p[kind % 2] = far_coordinate(bytes);
            } else {
                p = {bytes.coordinate(64), bytes.coordinate(64), 0.0f};
                // Points that only differ along the dropped axis.
                if (kind < 0x50) p.z = static_cast<float>(kind % 4);
            }
            const glm::dvec2 place(p.x, p.y);
            if (outline.points.size() > first && outline.points.back() == place) continue;
            outline.points.push_back(place);
            outline.positions.push_back(p);
        }
        while (outline.points.size() > first && outline.points.back() == outline.points[first]) drop();
        if (outline.points.size() - first < 3)
            while (outline.points.size() > first) drop();
        else
            outline.starts.push_back(static_cast<Index>(outline.points.size()));
    }
    return outline;
}

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// Where a corner lies: a point of the outline, or where edges of it cross.
glm::dvec2 place_of(const Outline& outline, const CapMesh& cap, Index corner)
{
    const std::size_t n = outline.points.size();
    return corner < n ? outline.points[corner] : glm::dvec2(cap.crossing_points[corner - n].position);
}

struct Areas
{
    double loops = 0, cap = 0, absolute = 0;
    double scale = 0;               ///< sum of what was added up, for rounding
    double turned_by_rounding = 0;  ///< twice the area of triangles that are as thin as rounding, and turned over
};

Areas areas_of(const Outline& outline, const CapMesh& cap)
{
    Areas areas;
    const glm::dvec2 origin = outline.points.front();
    const auto place = [&](Index i) { return place_of(outline, cap, i) - origin; };
    double largest = 0;
    for (const glm::dvec2& p : outline.points) largest = std::max({largest, std::abs(p.x), std::abs(p.y)});
    for (Index l = 0; l + 1 < outline.starts.size(); ++l)
        for (Index i = outline.starts[l]; i < outline.starts[l + 1]; ++i) {
            const glm::dvec2 a = place(i), b = place(outline.view().successor(i, l));
            areas.loops += cross(a, b) / 2;
            areas.scale += std::abs(a.x * b.y) + std::abs(a.y * b.x);
        }
    for (const CapTriangle& t : cap.triangles) {
        const glm::dvec2 a = place(t.corner[0]), b = place(t.corner[1]), c = place(t.corner[2]);
        // The same products as in the loops' sum, so that the same bound on their rounding holds.
        const double area = (cross(a, b) + cross(b, c) + cross(c, a)) / 2;
        areas.cap += area;
        areas.absolute += std::abs(area);
        const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
        const double thin = std::numeric_limits<float>::epsilon() * largest * longest;
        if (area < 0 && -area <= thin) areas.turned_by_rounding -= 2 * area;
        for (const auto& [p, q] : {std::pair{a, b}, {b, c}, {c, a}})
            areas.scale += std::abs(p.x * q.y) + std::abs(p.y * q.x);
    }
    return areas;
}

void require_linked(const Outline& outline, const CapMesh& cap, const std::string& way)
{
    std::vector<Index> successor(outline.points.size());
    for (Index l = 0; l + 1 < outline.starts.size(); ++l)
        for (Index i = outline.starts[l]; i < outline.starts[l + 1]; ++i) successor[i] = outline.view().successor(i, l);
    const auto at = [&](Index i) -> const glm::vec3& {
        const std::size_t n = outline.positions.size();
        return i < n ? outline.positions[i] : cap.crossing_points[i - n].position;
    };

    std::vector<int> uses(outline.points.size(), 0);
    for (Index t = 0; t < cap.triangles.size(); ++t)
        for (Index i = 0; i < 3; ++i) {
            const Index from = cap.triangles[t].corner[i], to = cap.triangles[t].corner[(i + 1) % 3];
            require(from < outline.points.size() + cap.crossing_points.size(),
                    way + ": corners are points of the outline or of crossings");
            require(at(from) != at(to), way + ": no triangle has two corners at one position");
            const CapLink link = cap.triangles[t].link[i];
            require(link != CapLink(), way + ": every edge is linked");
            if (link.is_outline()) {
                const Index edge = link.outline_edge();
                require(edge < uses.size(), way + ": links are to edges of the outline");
                ++uses[edge];
                require(at(edge) == at(from) && at(successor[edge]) == at(to),
                        way + ": an edge of the outline runs as its triangle");
            } else {
                require(link.triangle() < cap.triangles.size(), way + ": links are to triangles of the cap");
                const CapTriangle& other = cap.triangles[link.triangle()];
                require(other.link[link.corner()] == CapLink::to_triangle(t, i), way + ": links are mutual");
                require(
                    at(other.corner[link.corner()]) == at(to) && at(other.corner[(link.corner() + 1) % 3]) == at(from),
                    way + ": linked edges run against one another");
            }
        }
    for (const CrossingPoint& p : cap.crossing_points)
        require(p.edge < outline.points.size(), way + ": a crossing lies on an edge of the outline");
    for (const auto& [a, b] : cap.cancelled) {
        require(a < uses.size() && b < uses.size(), way + ": cancelled edges are those of the outline");
        ++uses[a];
        ++uses[b];
        require(at(a) == at(successor[b]) && at(b) == at(successor[a]), way + ": cancelled edges run forth and back");
    }
    require(std::all_of(uses.begin(), uses.end(), [](int n) { return n == 1; }),
            way + ": each edge of the outline is used once");
}

}  // namespace

void fuzz_cap(Bytes input)
{
    ByteReader bytes(input);
    const Outline outline = outline_from(bytes);
    if (outline.starts.size() < 2) return;

    struct Way
    {
        std::string name;
        std::unique_ptr<CapTriangulator> triangulator;
        bool never_refuses, covers_once;
    };
    // Kept from one input to the next: what a difficult outline leaves behind must not spoil an easy one.
    static const std::vector<Way> ways = [] {
        std::vector<Way> all;
        all.push_back({"convex", make_convex_triangulator(), false, true});
        all.push_back({"clipping", make_clipping_triangulator(), false, true});
        all.push_back({"nested", make_nested_triangulator(), false, true});
        all.push_back({"patient", make_patient_triangulator(), false, true});
        all.push_back({"constrained", make_constrained_triangulator(), false, false});
        all.push_back({"untangling", make_untangling_triangulator(make_constrained_triangulator(), make_route_finder()),
                       false, false});
        all.push_back({"topological", make_topological_triangulator(), true, false});
        return all;
    }();
    for (const Way& way : ways) {
        CapMesh cap, again;
        const bool closed = way.triangulator->triangulate(outline.view(), cap);
        require(closed || !way.never_refuses, way.name + ": never refuses");
        require(closed == way.triangulator->triangulate(outline.view(), again), way.name + ": decides the same twice");
        if (!closed) continue;
        require_linked(outline, cap, way.name);
        require(cap.triangles.size() == again.triangles.size() &&
                    std::equal(cap.triangles.begin(), cap.triangles.end(), again.triangles.begin(),
                               [](const CapTriangle& a, const CapTriangle& b) {
                                   return a.corner == b.corner && a.link == b.link;
                               }),
                way.name + ": gives the same cap twice");
        const Areas areas = areas_of(outline, cap);
        const double rounding = 1e-12 * areas.scale;
        require(std::abs(areas.cap - areas.loops) <= rounding, way.name + ": the cap has the area of its loops");
        const double turned = cap.turns_over ? areas.turned_by_rounding : 0.0;
        if (way.covers_once)
            require(std::abs(areas.absolute - areas.loops) <= rounding + turned,
                    way.name + ": nothing is covered twice, but for what rounding explains");
    }
}

}  // namespace kerf::core::fuzz
