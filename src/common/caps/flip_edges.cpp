#include "common/caps/flip_edges.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

namespace kerf::core {

static_assert(kMostFlippedTriangles < 32, "a bit for each triangle");

namespace {

/// The edge from corner i of a triangle to the next, and the triangle across.
struct Shared
{
    Index triangle, corner;
    CapLink across;
};

double cross(const glm::dvec2& a, const glm::dvec2& b)
{
    return a.x * b.y - a.y * b.x;
}

/// Whether the triangle runs counter-clockwise for certain, without the cost of an exact sign: what lies on a line within
/// rounding does not.
bool is_left_turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    // Share of both products by which rounding changes their difference at most: see turn().
    constexpr double kRounding = 0x1p-51;
    const double left = (b.x - a.x) * (c.y - b.y), right = (b.y - a.y) * (c.x - b.x);
    return left - right > kRounding * (std::abs(left) + std::abs(right));
}

/// Whether the angles at c and d, across the edge from a to b, are together more than half a turn: their sum's sine is below
/// zero by more than its rounding.
bool is_wide(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
    // Share of the terms' sizes by which rounding changes their sum: a dozen roundings of 2^-53 each. What lies on a circle
    // within that stays as it is, so that no edge is flipped to and fro.
    constexpr double kRounding = 0x1p-49;
    const glm::dvec2 ca = a - c, cb = b - c, da = a - d, db = b - d;
    const double first = cross(ca, cb) * glm::dot(da, db), second = cross(db, da) * glm::dot(ca, cb);
    return first + second < -kRounding * (std::abs(first) + std::abs(second));
}

/// Flips the edge if that is right. The triangle (a, b, c) and the one across, (b, a, d), become (a, d, c) and (d, b, c).
bool flip(std::span<const glm::dvec2> points, std::vector<CapTriangle>& triangles, const Shared& edge)
{
    const Index i = edge.corner, j = edge.across.corner(), s = edge.across.triangle();
    CapTriangle& t = triangles[edge.triangle];
    CapTriangle& u = triangles[s];
    const Index a = t.corner[i], b = t.corner[(i + 1) % 3], c = t.corner[(i + 2) % 3], d = u.corner[(j + 2) % 3];
    if (!is_wide(points[a], points[b], points[c], points[d])) return false;
    if (!is_left_turn(points[a], points[d], points[c]) || !is_left_turn(points[d], points[b], points[c])) return false;
    const CapLink bc = t.link[(i + 1) % 3], ca = t.link[(i + 2) % 3], ad = u.link[(j + 1) % 3],
                  db = u.link[(j + 2) % 3];
    t.corner = {a, d, c};
    u.corner = {d, b, c};
    connect(triangles, CapLink::to_triangle(edge.triangle, 0), ad);
    connect(triangles, CapLink::to_triangle(edge.triangle, 1), CapLink::to_triangle(s, 2));
    connect(triangles, CapLink::to_triangle(edge.triangle, 2), ca);
    connect(triangles, CapLink::to_triangle(s, 0), db);
    connect(triangles, CapLink::to_triangle(s, 1), bc);
    return true;
}

}  // namespace

void flip_edges(std::span<const glm::dvec2> points, std::vector<CapTriangle>& triangles)
{
    // Triangles with edges that are to be looked at. An edge is left to the later one of its two triangles.
    std::uint32_t waiting = (std::uint32_t{1} << triangles.size()) - 1;
    const auto waits = [&](Index t) { return (waiting >> t & 1u) != 0; };
    // Every flip makes the circles around its triangles smaller: there are no more than pairs of points, but for rounding.
    std::size_t flips_left = triangles.size() * triangles.size();
    while (waiting != 0 && flips_left > 0) {
        const auto t = static_cast<Index>(std::countr_zero(waiting));
        waiting &= waiting - 1;
        for (Index i = 0; i < 3; ++i) {
            const CapLink across = triangles[t].link[i];
            if (across.is_outline() || waits(across.triangle())) continue;
            if (!flip(points, triangles, {t, i, across})) continue;
            waiting |= std::uint32_t{1} << t | std::uint32_t{1} << across.triangle();
            --flips_left;
            break;
        }
    }
}

}  // namespace kerf::core
