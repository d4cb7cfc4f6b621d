// Flips leave a triangulation of the same outline, in which no triangle's circle holds the point across an edge.
//
// Points are whole numbers, so that the referee's determinants are exact.

#include "common/caps/flip_edges.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string>

#include "common/caps/clipping_triangulator.h"
#include "common/caps/convex_triangulator.h"
#include "support/fixtures.h"

namespace kerf::core {
namespace {

using Polygon = std::vector<glm::dvec2>;

/// Twice the signed area.
std::int64_t area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return std::int64_t(b.x - a.x) * std::int64_t(c.y - a.y) - std::int64_t(b.y - a.y) * std::int64_t(c.x - a.x);
}

/// Above 0 if d lies inside the circle through a, b and c, which run counter-clockwise.
std::int64_t in_circle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
    const auto lifted = [&](const glm::dvec2& p) {
        const std::int64_t x = std::int64_t(p.x - d.x), y = std::int64_t(p.y - d.y);
        return std::array{x, y, x * x + y * y};
    };
    const auto [ax, ay, az] = lifted(a);
    const auto [bx, by, bz] = lifted(b);
    const auto [cx, cy, cz] = lifted(c);
    return ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx);
}

std::vector<CapTriangle> triangles_of(const Polygon& loop)
{
    std::vector<glm::vec3> positions;
    for (const glm::dvec2& p : loop) positions.emplace_back(p.x, p.y, 0.0f);
    const std::vector<Index> starts{0, static_cast<Index>(loop.size())};
    const CapOutline outline{loop, positions, starts};
    CapMesh cap;
    if (!make_convex_triangulator()->triangulate(outline, cap) &&
        !make_clipping_triangulator()->triangulate(outline, cap))
        return {};
    return cap.triangles;
}

/// The points of a triangle, and the one across an edge of it.
std::array<glm::dvec2, 4> around(const Polygon& loop, const std::vector<CapTriangle>& all, Index t, Index i)
{
    const CapLink link = all[t].link[i];
    const auto corner = [&](Index of, Index at) { return loop[all[of].corner[at % 3]]; };
    return {corner(t, i), corner(t, i + 1), corner(t, i + 2), corner(link.triangle(), link.corner() + 2)};
}

void expect_delaunay(const Polygon& loop, const std::vector<CapTriangle>& before)
{
    std::vector<CapTriangle> after = before;
    flip_edges(loop, after);
    ASSERT_EQ(after.size(), before.size());
    std::int64_t area_before = 0, area_after = 0;
    std::vector<int> used(loop.size(), 0);
    for (Index t = 0; t < after.size(); ++t) {
        const auto twice = [&](const CapTriangle& each) {
            return area(loop[each.corner[0]], loop[each.corner[1]], loop[each.corner[2]]);
        };
        area_before += twice(before[t]);
        area_after += twice(after[t]);
        EXPECT_GE(twice(after[t]), 0) << "triangle " << t << " is turned over";
        for (Index i = 0; i < 3; ++i) {
            const CapLink link = after[t].link[i];
            if (link.is_outline()) {
                ++used[link.outline_edge()];
                EXPECT_EQ(after[t].corner[i], link.outline_edge());
                continue;
            }
            const CapTriangle& across = after[link.triangle()];
            EXPECT_EQ(across.link[link.corner()], CapLink::to_triangle(t, i));
            EXPECT_EQ(after[t].corner[i], across.corner[(link.corner() + 1) % 3]);
            EXPECT_EQ(after[t].corner[(i + 1) % 3], across.corner[link.corner()]);
            const auto [a, b, c, d] = around(loop, after, t, i);
            if (area(a, d, c) > 0 && area(d, b, c) > 0) {
                EXPECT_LE(in_circle(a, b, c, d), 0) << "the edge " << t << ", " << i << " is not Delaunay";
            }
        }
    }
    EXPECT_EQ(area_after, area_before);
    EXPECT_EQ(used, std::vector<int>(loop.size(), 1));
}

/// Around (0, 0), each point as far as it likes.
Polygon random_star(test::Random& random, std::size_t points, double least)
{
    Polygon loop;
    for (std::size_t i = 0; i < points; ++i) {
        const double angle = 2 * std::numbers::pi * double(i) / double(points);
        const double radius = 1000.0 * (least + (1.0 - least) * random.uniform());
        const glm::dvec2 p{std::round(radius * std::cos(angle)), std::round(radius * std::sin(angle))};
        if (loop.empty() || p != loop.back()) loop.push_back(p);
    }
    return loop;
}

TEST(FlipEdges, MakesTriangulationsDelaunay)
{
    test::Random random(5);
    std::size_t changed = 0;
    for (int i = 0; i < 3000; ++i) {
        SCOPED_TRACE("loop " + std::to_string(i));
        const std::size_t points = 4 + random.next() % (kMostFlippedTriangles - 1);
        const Polygon loop = random_star(random, points, i % 3 == 0 ? 1.0 : 0.2);
        const std::vector<CapTriangle> before = triangles_of(loop);
        if (before.empty()) continue;
        ++changed;
        expect_delaunay(loop, before);
        if (HasFailure()) return;
    }
    EXPECT_GT(changed, 2000u);
}

TEST(FlipEdges, EndsWherePointsLieOnOneCircle)
{
    // All triangulations of a square, or of points on a circle, are Delaunay: nothing is flipped to and fro.
    const Polygon square{{0, 0}, {10, 0}, {10, 10}, {0, 10}};
    const Polygon circle{{5, 0},  {4, 3},   {3, 4},   {0, 5},  {-3, 4}, {-4, 3},
                         {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}};
    for (const Polygon& loop : {square, circle}) {
        const std::vector<CapTriangle> before = triangles_of(loop);
        ASSERT_EQ(before.size(), loop.size() - 2);
        expect_delaunay(loop, before);
    }
}

TEST(FlipEdges, LeavesNoTriangleAlongAStraightSide)
{
    // A square with points along its sides, bent outward by as little as a rounding might. Three points of a side are in
    // one triangle only where the outline forces it, and it forces none.
    Polygon loop;
    const auto add_side = [&](glm::dvec2 from, glm::dvec2 to, glm::dvec2 outward) {
        for (const int i : {0, 1, 2, 3, 4, 5})
            loop.push_back(from + (to - from) * (i / 6.0) + outward * double(i * (6 - i)));
    };
    constexpr double kSide = 6'000'000;
    add_side({0, 0}, {kSide, 0}, {0, -1});
    add_side({kSide, 0}, {kSide, kSide}, {1, 0});
    add_side({kSide, kSide}, {0, kSide}, {0, 1});
    add_side({0, kSide}, {0, 0}, {-1, 0});
    std::vector<CapTriangle> triangles = triangles_of(loop);
    ASSERT_EQ(triangles.size(), loop.size() - 2);
    const auto flattest = [&] {
        std::int64_t least = std::int64_t(kSide * kSide);
        for (const CapTriangle& t : triangles)
            least = std::min(least, area(loop[t.corner[0]], loop[t.corner[1]], loop[t.corner[2]]));
        return double(least) / (kSide * kSide);
    };
    EXPECT_LT(flattest(), 1e-4) << "the way that closes it leaves slivers, or this test shows nothing";
    flip_edges(loop, triangles);
    EXPECT_GT(flattest(), 0.01);
}

}  // namespace
}  // namespace kerf::core
