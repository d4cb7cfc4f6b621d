#include "common/proxy/convex_hull.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>

#include "common/mesh/box.h"
#include "common/shapes/shapes.h"
#include "common/support/random.h"

namespace kerf::core {
namespace {

using Points = std::vector<glm::vec3>;

glm::dvec3 corner(const Points& points, const ConvexHull& hull, std::uint32_t i)
{
    return glm::dvec3(points[hull.corners[i]]);
}

double volume_of(const Points& points, const ConvexHull& hull)
{
    double volume = 0.0;
    for (const Triangle& t : hull.faces) {
        volume +=
            glm::dot(corner(points, hull, t[0]), glm::cross(corner(points, hull, t[1]), corner(points, hull, t[2]))) /
            6.0;
    }
    return volume;
}

// The volume by trying every plane through three points; for points of which no four share a plane.
double brute_force_volume(const Points& points)
{
    double volume = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        for (std::size_t j = i + 1; j < points.size(); ++j) {
            for (std::size_t k = j + 1; k < points.size(); ++k) {
                const glm::dvec3 a(points[i]), b(points[j]), c(points[k]);
                const glm::dvec3 n = glm::cross(b - a, c - a);
                bool above = false, below = false;
                for (std::size_t l = 0; l < points.size(); ++l) {
                    if (l == i || l == j || l == k) continue;
                    const double side = glm::dot(n, glm::dvec3(points[l]) - a);
                    above |= side > 0;
                    below |= side < 0;
                }
                const double six = glm::dot(a, glm::cross(b, c));
                if (!above) volume += six / 6.0;
                if (!below) volume -= six / 6.0;
            }
        }
    }
    return volume;
}

// A closed convex polyhedron of different corners with every input point inside, to the hull's lattice.
void expect_hull(const Points& points, const ConvexHull& hull)
{
    Box box;
    for (const glm::vec3& p : points) box.add(p);
    const double part = glm::length(glm::dvec3(box.hi) - glm::dvec3(box.lo)) / kHullLattice;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::set<std::uint32_t> used;
    for (const Triangle& t : hull.faces) {
        for (std::size_t k = 0; k < 3; ++k) {
            used.insert(t[k]);
            ++edges[{t[k], t[(k + 1) % 3]}];
        }
        const glm::dvec3 a = corner(points, hull, t[0]), b = corner(points, hull, t[1]), c = corner(points, hull, t[2]);
        const glm::dvec3 n = glm::cross(b - a, c - a);
        if (glm::length(n) < 100.0 * part * part) continue;  // a sliver: its plane is rounding
        double most = 0.0;
        for (const glm::vec3& p : points) {
            // The corners of a face are off by a part each; a point far from a small face sees that magnified.
            const double reach = glm::length(glm::dvec3(p) - a);
            const double height =
                glm::length(n) / std::max({glm::length(b - a), glm::length(c - b), glm::length(a - c)});
            most = std::max(most, glm::dot(glm::normalize(n), glm::dvec3(p) - a) / (1.0 + reach / height));
        }
        EXPECT_LE(most, 2.0 * part);
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_EQ(edges.count({edge.second, edge.first}), 1u);
    }
    EXPECT_EQ(used.size(), hull.corners.size());
    EXPECT_EQ(hull.corners.size() + hull.faces.size(), edges.size() / 2 + 2) << "Euler";
    std::set<std::array<float, 3>> places;
    for (const std::uint32_t i : hull.corners) places.insert({points.at(i).x, points[i].y, points[i].z});
    EXPECT_EQ(places.size(), hull.corners.size());
}

Points random_points(std::uint64_t seed, std::size_t count)
{
    core::Random random(seed);
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
        const double x = random.unit(), y = random.unit(), z = random.unit();
        points.emplace_back(2.0 * x - 1.0, 3.0 * y, z + 100.0);
    }
    return points;
}

TEST(ConvexHull, AgreesWithBruteForceOnRandomPoints)
{
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE(seed);
        const Points points = random_points(seed, 4 + seed % 20);
        const ConvexHull hull = convex_hull(points);
        expect_hull(points, hull);
        EXPECT_NEAR(volume_of(points, hull), brute_force_volume(points), 2e-3 * brute_force_volume(points) + 1e-4);
    }
}

TEST(ConvexHull, ReachesAsFarAsThePointsInEveryDirection)
{
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Points points = random_points(seed, 2000);
        const ConvexHull hull = convex_hull(points);
        expect_hull(points, hull);
        core::Random random(seed);
        for (int k = 0; k < 200; ++k) {
            const double x = random.unit() - 0.5, y = random.unit() - 0.5, z = random.unit() - 0.5;
            const glm::dvec3 d = glm::normalize(glm::dvec3(x, y, z));
            double all = -1e9, corners = -1e9;
            for (const glm::vec3& p : points) all = std::max(all, glm::dot(d, glm::dvec3(p)));
            for (const std::uint32_t i : hull.corners) corners = std::max(corners, glm::dot(d, glm::dvec3(points[i])));
            EXPECT_LE(all - corners, 2.0 * 3.0 / kHullLattice);
        }
    }
}

TEST(ConvexHull, OfAGridHasTheCornersOfTheBoxOnly)
{
    Points grid;
    for (int i = 0; i < 5; ++i) {
        for (int j = 0; j < 5; ++j) {
            for (int k = 0; k < 5; ++k) grid.emplace_back(i, 2 * j, 3 * k);
        }
    }
    // Three times over: duplicates change nothing.
    const std::size_t once = grid.size();
    for (std::size_t i = 0; i < 2 * once; ++i) grid.push_back(grid[i % once]);
    const ConvexHull hull = convex_hull(grid);
    EXPECT_EQ(hull.corners.size(), 8u);
    EXPECT_EQ(hull.faces.size(), 12u);
    expect_hull(grid, hull);
    EXPECT_EQ(volume_of(grid, hull), 4.0 * 8.0 * 12.0);
}

TEST(ConvexHull, OfAnIcosphereHasEveryPoint)
{
    Points points;
    for (const Vertex& v : shapes::icosphere(1.0f, 4).vertices) points.push_back(v.position);
    const ConvexHull hull = convex_hull(points);
    EXPECT_EQ(hull.corners.size(), 10u * 16 + 2);
    EXPECT_EQ(hull.faces.size(), 320u);
    expect_hull(points, hull);
}

TEST(ConvexHull, OfAThinSlabAlongTheAxesHasFaces)
{
    Points slab;
    for (int i = 0; i < 8; ++i) slab.emplace_back(i & 1, i >> 1 & 1, float(i >> 2) * 1e-5f);
    const ConvexHull hull = convex_hull(slab);
    EXPECT_EQ(hull.corners.size(), 8u);
    EXPECT_EQ(hull.faces.size(), 12u);
    EXPECT_GT(volume_of(slab, hull), 0.0);
}

// The positions of a flat set's corners, as a set.
std::set<std::array<float, 3>> flat_corners(const Points& points)
{
    const ConvexHull hull = convex_hull(points);
    EXPECT_TRUE(hull.faces.empty());
    std::set<std::array<float, 3>> places;
    for (const std::uint32_t i : hull.corners) places.insert({points.at(i).x, points[i].y, points[i].z});
    EXPECT_EQ(places.size(), hull.corners.size()) << "each once";
    return places;
}

TEST(ConvexHull, OfAFlatSetIsItsExtremePoints)
{
    EXPECT_TRUE(flat_corners({}).empty());
    EXPECT_EQ(flat_corners({{1, 2, 3}}), (std::set<std::array<float, 3>>{{1, 2, 3}}));
    EXPECT_EQ(flat_corners(Points(100, {1, 2, 3})), (std::set<std::array<float, 3>>{{1, 2, 3}}));
    EXPECT_EQ(flat_corners({{1, 2, 3}, {4, 5, 6}, {1, 2, 3}}), (std::set<std::array<float, 3>>{{1, 2, 3}, {4, 5, 6}}));
    for (const glm::vec3 along : {glm::vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 2, 3}, {0, -1, 1}}) {
        Points line;
        for (const int i : {3, 1, 4, 1, 5, 9, 2, 6}) line.push_back(along * float(i));
        const glm::vec3 far = along * 9.0f;
        EXPECT_EQ(flat_corners(line),
                  (std::set<std::array<float, 3>>{{along.x, along.y, along.z}, {far.x, far.y, far.z}}));
    }
    using Pair = std::array<glm::vec3, 2>;
    for (const auto& [u, v] : {Pair{{{1, 0, 0}, {0, 1, 0}}}, Pair{{{0, 1, 0}, {0, 0, 1}}}, Pair{{{0, 0, 1}, {1, 0, 0}}},
                               Pair{{{1, 2, 3}, {-2, 1, 1}}}, Pair{{{0.1f, 0.7f, 0.3f}, {0.3f, -0.2f, 0.9f}}}}) {
        Points grid;
        for (int i = 0; i < 6; ++i) {
            for (int j = 0; j < 6; ++j) grid.push_back(float(i) * u + float(j) * v);
        }
        const ConvexHull hull = convex_hull(grid);
        EXPECT_TRUE(hull.faces.empty());
        // Rounded coordinates may make a few points of the outline extreme that are not so on paper.
        const auto has = [&](std::uint32_t i) { return std::count(hull.corners.begin(), hull.corners.end(), i) == 1; };
        EXPECT_TRUE(has(0) && has(5) && has(30) && has(35));
        for (const std::uint32_t i : hull.corners) {
            EXPECT_TRUE(i / 6 == 0 || i / 6 == 5 || i % 6 == 0 || i % 6 == 5) << i;
        }
        if (u.x == std::floor(u.x)) {
            EXPECT_EQ(hull.corners.size(), 4u);
        }
    }
}

// Points on a coarse lattice: duplicates, collinear and coplanar subsets all the time.
RC_GTEST_PROP(ConvexHull, OfLatticePointsHoldsThemAll, ())
{
    const auto coordinate = rc::gen::map(rc::gen::inRange(-2, 3), [](int i) { return float(i); });
    const auto values = *rc::gen::resize(60, rc::gen::container<std::vector<float>>(coordinate));
    Points points;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3) points.emplace_back(values[i], values[i + 1], values[i + 2]);
    const ConvexHull hull = convex_hull(points);
    for (const std::uint32_t i : hull.corners) RC_ASSERT(i < points.size());
    for (const Triangle& t : hull.faces) {
        const glm::dvec3 a = corner(points, hull, t[0]), b = corner(points, hull, t[1]), c = corner(points, hull, t[2]);
        const glm::dvec3 n = glm::cross(b - a, c - a);
        RC_ASSERT(glm::length(n) > 0.0);
        for (const glm::vec3& p : points) RC_ASSERT(glm::dot(n, glm::dvec3(p) - a) <= 1e-9);
    }
    if (hull.faces.empty()) {
        // Flat: no four points may span a volume.
        for (std::size_t i = 3; i < points.size(); ++i) {
            for (std::size_t j = 2; j < i; ++j) {
                for (std::size_t k = 1; k < j; ++k) {
                    const glm::dvec3 o(points[0]);
                    RC_ASSERT(glm::dot(glm::dvec3(points[i]) - o,
                                       glm::cross(glm::dvec3(points[j]) - o, glm::dvec3(points[k]) - o)) == 0.0);
                }
            }
        }
    }
}

TEST(ConvexHull, OfPointsScaledByAPowerOfTwoIsTheSame)
{
    for (const char* name : {"box", "icosphere", "torus"})
        for (const float offset : {0.0f, 3e4f}) {
            const TriangleSoup soup = *shapes::make(name, 200, 1);
            Points points;
            for (const Vertex& v : soup.vertices)
                // Multiples of 2^-12: no digit is lost near zero, however small the scale.
                points.push_back(glm::vec3(glm::round(glm::dvec3(v.position) * 0x1p12) * 0x1p-12) +
                                 glm::vec3(offset, 0.0f, 0.0f));
            const ConvexHull hull = convex_hull(points);
            const double volume = volume_of(points, hull);
            EXPECT_GT(volume, 0.0);
            for (int exponent = -100; exponent <= 100; exponent += 5) {
                SCOPED_TRACE(std::string(name) + " at " + std::to_string(offset) + ", 2^" + std::to_string(exponent));
                Points scaled = points;
                for (glm::vec3& p : scaled) p *= std::ldexp(1.0f, exponent);
                const ConvexHull other = convex_hull(scaled);
                EXPECT_EQ(other.corners, hull.corners);
                EXPECT_EQ(other.faces, hull.faces);
                EXPECT_EQ(volume_of(scaled, other), std::ldexp(volume, 3 * exponent));
            }
        }
}

TEST(ConvexHull, OfACubeThatFillsTheFloatsHasItsCorners)
{
    for (const float size : {3e38f, 1e31f, 1e-37f}) {
        Points points;
        for (int i = 0; i < 8; ++i)
            points.push_back(size * (2.0f * glm::vec3(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1)) - 1.0f));
        const ConvexHull hull = convex_hull(points);
        EXPECT_EQ(hull.corners.size(), 8u);
        EXPECT_EQ(hull.faces.size(), 12u);
    }
}

TEST(ConvexHull, SurvivesExtremeCoordinates)
{
    EXPECT_LE(convex_hull(Points{{3e38f, 0, 0}, {-3e38f, 0, 0}, {0, 3e38f, 0}, {0, 0, 3e38f}}).corners.size(), 4u);
    EXPECT_LE(convex_hull(Points{{1e-42f, 0, 0}, {-1e-42f, 0, 0}, {0, 1e-42f, 0}, {0, 0, 1e-42f}}).corners.size(), 4u);
}

}  // namespace
}  // namespace kerf::core
