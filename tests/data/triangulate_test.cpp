#include "maker/triangulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <stdexcept>

#include "maker/delaunay.h"

namespace kerf::maker {
namespace {

double signed_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// A star of `points` rays: concave at every second corner.
std::vector<glm::dvec2> star(int points)
{
    std::vector<glm::dvec2> corners;
    for (int i = 0; i < 2 * points; ++i) {
        const double angle = std::acos(-1.0) * i / points, radius = i % 2 == 0 ? 1.0 : 0.4;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return corners;
}

double polygon_area(const std::vector<glm::dvec2>& p)
{
    double area = 0;
    for (std::size_t i = 0; i < p.size(); ++i) area += signed_area({0, 0}, p[i], p[(i + 1) % p.size()]);
    return area;
}

std::vector<glm::dvec3> lifted(const std::vector<glm::dvec2>& polygon)
{
    std::vector<glm::dvec3> points;
    for (const auto& p : polygon) points.push_back({p.x, p.y, 0.3 * p.x - 0.2 * p.y});
    return points;
}

TEST(Triangulate, CoversAConcavePolygonOnce)
{
    for (const int rays : {3, 5, 8, 13}) {
        const auto polygon = star(rays);
        const auto triangles = triangulate(lifted(polygon));
        EXPECT_EQ(triangles.size(), polygon.size() - 2);
        double area = 0;
        for (const auto& [a, b, c] : triangles) {
            const double one = signed_area(polygon[std::size_t(a)], polygon[std::size_t(b)], polygon[std::size_t(c)]);
            EXPECT_GT(one, 0.0);
            area += one;
        }
        EXPECT_NEAR(area, polygon_area(polygon), 1e-12);
    }
}

TEST(Triangulate, PutsNoTriangleOnThreeCornersOfOneSide)
{
    const auto triangles = triangulate({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}});
    ASSERT_EQ(triangles.size(), 3u);
    for (const auto& t : triangles) EXPECT_NE(std::set<int>(t.begin(), t.end()), (std::set<int>{0, 1, 2}));
}

TEST(Triangulate, RefusesAPolygonThatCrossesItself)
{
    EXPECT_THROW(triangulate({{0, 0, 0}, {2, 0, 0}, {0, 1, 0}, {2, 1.5, 0}}), std::logic_error);
}

TEST(Delaunay, KeepsTheOutlineAndUsesEveryPoint)
{
    const auto polygon = star(6);
    const std::vector<glm::dvec2> inside{{0.0, 0.0}, {0.5, 0.02}, {0.1, 0.2}, {-0.2, 0.1}, {0.05, -0.3}, {-0.3, 0.0}};
    std::vector<glm::dvec2> all = polygon;
    all.insert(all.end(), inside.begin(), inside.end());
    const auto at = [&](int i) { return all[std::size_t(i)]; };
    const auto triangles = delaunay(polygon, inside);
    EXPECT_EQ(triangles.size(), polygon.size() + 2 * inside.size() - 2);
    std::set<std::pair<int, int>> edges;
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
        area += signed_area(at(a), at(b), at(c));
        EXPECT_GT(signed_area(at(a), at(b), at(c)), 0.0);
        edges.insert({{a, b}, {b, c}, {c, a}});
    }
    EXPECT_NEAR(area, polygon_area(polygon), 1e-12);
    const int n = int(polygon.size());
    for (int i = 0; i < n; ++i) EXPECT_TRUE(edges.contains({i, (i + 1) % n}));
}

TEST(Delaunay, LeavesNoPointInTheCircleOfATriangleOfAConvexPolygon)
{
    const std::vector<glm::dvec2> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const std::vector<glm::dvec2> inside{{0.3, 0.21}, {0.62, 0.4}, {0.45, 0.8}, {0.12, 0.55}, {0.8, 0.75}, {0.7, 0.13}};
    std::vector<glm::dvec2> all = square;
    all.insert(all.end(), inside.begin(), inside.end());
    for (const auto& t : delaunay(square, inside)) {
        const glm::dvec2 a = all[std::size_t(t[0])], b = all[std::size_t(t[1])] - a, c = all[std::size_t(t[2])] - a;
        // The circumcentre, from the two bisectors.
        const double d = 2 * (b.x * c.y - b.y * c.x), bb = b.x * b.x + b.y * b.y, cc = c.x * c.x + c.y * c.y;
        const glm::dvec2 centre{(c.y * bb - b.y * cc) / d, (b.x * cc - c.x * bb) / d};
        const double radius = std::hypot(centre.x, centre.y);
        for (const auto& p : all) EXPECT_GE(std::hypot(p.x - a.x - centre.x, p.y - a.y - centre.y), radius - 1e-9);
    }
}

TEST(Delaunay, RefusesAPointOutside)
{
    EXPECT_THROW(delaunay({{0, 0}, {1, 0}, {0, 1}}, {{2.0, 2.0}}), std::logic_error);
}

}  // namespace
}  // namespace kerf::maker
