#include "common/io/polygon.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <vector>

namespace kerf::core::io {
namespace {

Buffer<Vertex> vertices_at(const std::vector<glm::vec3>& positions)
{
    Buffer<Vertex> vertices;
    for (const glm::vec3& p : positions) vertices.push_back({p, {}, {}});
    return vertices;
}

std::vector<std::uint32_t> in_order(std::size_t n)
{
    std::vector<std::uint32_t> indices(n);
    std::iota(indices.begin(), indices.end(), 0u);
    return indices;
}

Buffer<Triangle> triangulated(const std::vector<glm::vec3>& positions)
{
    Buffer<Triangle> triangles;
    ConcaveBudget budget;
    EXPECT_TRUE(triangulate_polygon(in_order(positions.size()), vertices_at(positions), triangles, budget));
    return triangles;
}

glm::dvec3 area_vector(const std::vector<glm::vec3>& p, const Triangle& t)
{
    return 0.5 * glm::cross(glm::dvec3(p[t[1]]) - glm::dvec3(p[t[0]]), glm::dvec3(p[t[2]]) - glm::dvec3(p[t[0]]));
}

/// Sum of the triangles' areas as if none faced the other way: larger than the polygon's area when some overlap.
double unsigned_area(const std::vector<glm::vec3>& p, const Buffer<Triangle>& triangles)
{
    double sum = 0.0;
    for (const Triangle& t : triangles) sum += glm::length(area_vector(p, t));
    return sum;
}

TEST(TriangulatePolygon, MakesAFanOfAConvexOne)
{
    const Buffer<Triangle> triangles = triangulated({{0, 0, 0}, {2, 0, 0}, {3, 2, 0}, {1, 3, 0}, {-1, 1, 0}});
    EXPECT_EQ(triangles, (Buffer<Triangle>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}}));
}

TEST(TriangulatePolygon, CoversAConcaveOneOnceInEveryPlaneAndFromEveryCorner)
{
    // An arrow head, whose fan from most corners leaves the outline.
    const std::vector<glm::vec3> flat{{0, 0, 0}, {4, 1, 0}, {0, 2, 0}, {1, 1, 0}};
    const double area = 3.0;
    for (int axis = 0; axis < 3; ++axis)
        for (const float sign : {1.0f, -1.0f})
            for (std::size_t first = 0; first < flat.size(); ++first) {
                std::vector<glm::vec3> p;
                for (std::size_t i = 0; i < flat.size(); ++i) {
                    const glm::vec3& q = flat[(first + i) % flat.size()];
                    glm::vec3 turned;
                    turned[axis] = sign * 0.25f * q.x;
                    turned[(axis + 1) % 3] = q.x;
                    turned[(axis + 2) % 3] = sign * q.y;
                    p.push_back(turned);
                }
                const Buffer<Triangle> triangles = triangulated(p);
                ASSERT_EQ(triangles.size(), 2u);
                EXPECT_NEAR(unsigned_area(p, triangles), area * std::sqrt(1.0625), 1e-6);
            }
}

TEST(TriangulatePolygon, LeavesNoFlatTriangleWhereCornersAreInLine)
{
    const std::vector<glm::vec3> p{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
    for (const Triangle& t : triangulated(p)) EXPECT_GT(glm::length(area_vector(p, t)), 0.0);
}

TEST(TriangulatePolygon, AnswersForOutlinesThatCrossThemselvesOrHaveNoArea)
{
    EXPECT_EQ(triangulated({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).size(), 2u);
    EXPECT_EQ(triangulated({{0, 0, 0}, {1, 1, 1}, {2, 2, 2}, {3, 3, 3}, {1, 1, 1}}).size(), 3u);
    EXPECT_EQ(triangulated({{5, 5, 5}, {5, 5, 5}, {5, 5, 5}, {5, 5, 5}}).size(), 2u);
}

TEST(TriangulatePolygon, RefusesAConcaveOneThatWouldTakeTooLong)
{
    std::vector<glm::vec3> comb;
    for (std::size_t i = 0; i <= kMostConcaveCorners / 2; ++i) {
        comb.push_back({float(i), 0, 0});
        comb.push_back({float(i), i % 2 == 0 ? 1.0f : 2.0f, 0});
    }
    Buffer<Triangle> triangles;
    ConcaveBudget budget;
    EXPECT_FALSE(triangulate_polygon(in_order(comb.size()), vertices_at(comb), triangles, budget));
    EXPECT_TRUE(triangles.empty());
}

TEST(TriangulatePolygon, HasABudgetForAllLongConcaveOnesOfAFile)
{
    ConcaveBudget budget;
    for (int i = 0; i < 4; ++i) EXPECT_TRUE(budget.spend(kMostConcaveCorners));
    EXPECT_FALSE(budget.spend(100));
    for (int i = 0; i < 1'000'000; ++i) ASSERT_TRUE(budget.spend(64));
}

RC_GTEST_PROP(TriangulatePolygon, CoversStarShapedOutlinesExactlyOnce, ())
{
    const auto n = static_cast<std::size_t>(*rc::gen::inRange(4, 60));
    std::vector<glm::vec3> p;
    for (std::size_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * double(i) / double(n);
        const double radius = 0.05 + 0.001 * *rc::gen::inRange(0, 1000);
        p.emplace_back(float(radius * std::cos(angle)), float(radius * std::sin(angle)), 0.0f);
    }
    Buffer<Triangle> triangles;
    ConcaveBudget budget;
    RC_ASSERT(triangulate_polygon(in_order(n), vertices_at(p), triangles, budget));
    RC_ASSERT(triangles.size() == n - 2);
    double area = 0.0;  // shoelace
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec3 a(p[i]), b(p[(i + 1) % n]);
        area += 0.5 * (a.x * b.y - a.y * b.x);
    }
    RC_ASSERT(std::abs(unsigned_area(p, triangles) - area) < 1e-9);
}

}  // namespace
}  // namespace kerf::core::io
