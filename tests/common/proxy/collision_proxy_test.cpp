#include "common/proxy/collision_proxy.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <set>

#include "common/mesh/support_points.h"
#include "common/shapes/shapes.h"
#include "common/support/random.h"

namespace kerf::core {
namespace {

bool before(const glm::vec3& a, const glm::vec3& b)
{
    return std::array{a.x, a.y, a.z} < std::array{b.x, b.y, b.z};
}

std::array<glm::vec3, kSupportDirections> brute_force(std::span<const Vertex> vertices)
{
    std::array<glm::vec3, kSupportDirections> result;
    for (std::size_t i = 0; i < kSupportDirections; ++i) {
        const glm::vec3 d = support_directions()[i];
        const Vertex* best = &vertices[0];
        for (const Vertex& v : vertices) {
            const float value = support_value(d, v.position), most = support_value(d, best->position);
            if (value > most || (value == most && before(v.position, best->position))) best = &v;
        }
        result[i] = best->position;
    }
    return result;
}

double volume_of(const CollisionProxy& proxy)
{
    double volume = 0.0;
    for (const Triangle& t : proxy.kind == ProxyKind::full_hull ? proxy.faces : hull_faces(proxy.points)) {
        const glm::dvec3 a(proxy.points[t[0]]), b(proxy.points[t[1]]), c(proxy.points[t[2]]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return volume;
}

TEST(SupportDirections, AreUnitOppositePairsWithTheAxesAmongThem)
{
    const auto& directions = support_directions();
    const auto has = [&](const glm::vec3& d) { return std::count(directions.begin(), directions.end(), d) == 1; };
    for (const glm::vec3& d : directions) {
        EXPECT_NEAR(glm::length(glm::dvec3(d)), 1.0, 1e-7);
        EXPECT_TRUE(has(d));
        EXPECT_TRUE(has(-d));
    }
    for (const glm::vec3 axis : {glm::vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) EXPECT_TRUE(has(axis));
}

TEST(SupportDirections, LeaveNoGapWiderThan25Degrees)
{
    double least = 1.0;
    for (const Vertex& v : shapes::icosphere(1.0f, 60).vertices) {
        float most = -1.0f;
        for (const glm::vec3& d : support_directions()) most = std::max(most, support_value(d, v.position));
        least = std::min(least, double(most));
    }
    EXPECT_GT(least, std::cos(glm::radians(24.6)));
}

TEST(SupportPoints, AreThoseOfASimpleLoopForEveryShapeInAnyOrder)
{
    for (const std::string& name : shapes::names()) {
        SCOPED_TRACE(name);
        const TriangleSoup soup = *shapes::make(name, 3000, 1);
        const auto expected = brute_force(soup.vertices);
        EXPECT_EQ(support_points(soup.vertices), expected);
        for (const std::uint64_t seed : {1, 2}) {
            EXPECT_EQ(support_points(shapes::shuffled(soup, seed).vertices), expected);
        }
    }
}

RC_GTEST_PROP(SupportPoints, AreThoseOfASimpleLoopForAnyNumberOfVertices, ())
{
    // Few different coordinates: ties everywhere.
    const std::size_t count = *rc::gen::inRange<std::size_t>(1, 400);
    core::Random random(*rc::gen::arbitrary<std::uint32_t>());
    const std::uint32_t values = *rc::gen::inRange(1u, 20u);
    Buffer<Vertex> vertices(count);
    for (Vertex& v : vertices) {
        const float x = float(random.below(values)), y = float(random.below(values)), z = float(random.below(values));
        v = {{x - 5.0f, y * 0.3f, z}, {0, 0, 1}, {0, 0}};
    }
    RC_ASSERT(support_points(vertices) == brute_force(vertices));
}

TEST(CollisionProxy, OfNoVerticesIsEmpty)
{
    for (const ProxyKind kind : {ProxyKind::box, ProxyKind::sphere, ProxyKind::bounded_hull, ProxyKind::full_hull}) {
        const CollisionProxy proxy = collision_proxy(kind, {});
        EXPECT_EQ(proxy.kind, kind);
        EXPECT_TRUE(proxy.box.empty());
        EXPECT_TRUE(proxy.points.empty());
        EXPECT_TRUE(proxy.faces.empty());
    }
    EXPECT_TRUE(bounded_hull(Box{}, {}).points.empty());
}

TEST(CollisionProxy, HasTheExactBoxWhateverItsKind)
{
    const TriangleSoup soup = shapes::asteroid(2000, 4);
    Box box;
    for (const Vertex& v : soup.vertices) box.add(v.position);
    for (const ProxyKind kind : {ProxyKind::box, ProxyKind::sphere, ProxyKind::bounded_hull, ProxyKind::full_hull}) {
        const CollisionProxy proxy = collision_proxy(kind, soup.vertices);
        EXPECT_EQ(proxy.kind, kind);
        EXPECT_EQ(proxy.box.lo, box.lo) << name_of(kind);
        EXPECT_EQ(proxy.box.hi, box.hi) << name_of(kind);
    }
}

TEST(CollisionProxy, SphereHoldsEveryVertexAndIsNotMuchTooLarge)
{
    for (const std::string& name : shapes::names()) {
        SCOPED_TRACE(name);
        const TriangleSoup soup = *shapes::make(name, 2000, 1);
        const CollisionProxy proxy = collision_proxy(ProxyKind::sphere, soup.vertices);
        double farthest = 0.0, widest = 0.0;
        for (const Vertex& v : soup.vertices) {
            farthest = std::max(farthest, glm::length(glm::dvec3(v.position) - glm::dvec3(proxy.centre)));
        }
        for (int axis = 0; axis < 3; ++axis) {
            widest = std::max(widest, double(proxy.box.hi[axis]) - double(proxy.box.lo[axis]));
        }
        EXPECT_LE(farthest, double(proxy.radius));
        // No sphere around the box is smaller than half its longest side.
        EXPECT_LE(double(proxy.radius), 0.5 * widest * std::sqrt(3.0) * 1.0001);
    }
    const Vertex one{{1, 2, 3}, {0, 0, 1}, {0, 0}};
    EXPECT_EQ(collision_proxy(ProxyKind::sphere, {&one, 1}).radius, 0.0f);
}

TEST(CollisionProxy, FullHullOfAConvexShapeIsTheShape)
{
    const CollisionProxy ico = collision_proxy(ProxyKind::full_hull, shapes::icosphere(1.0f, 1).vertices);
    EXPECT_EQ(ico.points.size(), 12u);
    EXPECT_EQ(ico.faces.size(), 20u);
    const CollisionProxy box = collision_proxy(ProxyKind::full_hull, shapes::box({1, 2, 4}, {9, 9, 9}).vertices);
    EXPECT_EQ(box.points.size(), 8u);
    EXPECT_NEAR(volume_of(box), 8.0, 1e-9);
}

TEST(BoundedHull, IsMadeOfVerticesAndLiesInsideTheFullHull)
{
    for (const std::string& name : shapes::names()) {
        SCOPED_TRACE(name);
        const TriangleSoup soup = *shapes::make(name, 3000, 1);
        const CollisionProxy bounded = collision_proxy(ProxyKind::bounded_hull, soup.vertices);
        const CollisionProxy full = collision_proxy(ProxyKind::full_hull, soup.vertices);
        EXPECT_GE(bounded.points.size(), 4u);
        EXPECT_LE(bounded.points.size(), kSupportDirections);
        EXPECT_LE(volume_of(bounded), volume_of(full) * 1.001);
        EXPECT_GE(volume_of(bounded), volume_of(full) * 0.78);
        std::set<std::array<float, 3>> places;
        for (const Vertex& v : soup.vertices) places.insert({v.position.x, v.position.y, v.position.z});
        for (const glm::vec3& p : bounded.points) EXPECT_EQ(places.count({p.x, p.y, p.z}), 1u);
    }
}

TEST(BoundedHull, IsAsGoodAsDocumented)
{
    const auto ratio = [](const TriangleSoup& soup) {
        return volume_of(collision_proxy(ProxyKind::bounded_hull, soup.vertices)) /
               volume_of(collision_proxy(ProxyKind::full_hull, soup.vertices));
    };
    EXPECT_NEAR(ratio(shapes::icosphere(1.0f, 40)), 0.82, 0.01);
    EXPECT_NEAR(ratio(shapes::cylinder(0.5f, 1.0f, 200, 20)), 0.96, 0.01);
    EXPECT_NEAR(ratio(shapes::torus(1.0f, 0.4f, 100, 40)), 0.81, 0.01);
    EXPECT_NEAR(ratio(shapes::asteroid(100000, 1)), 0.87, 0.01);
    EXPECT_GT(ratio(shapes::box(glm::vec3(1.0f), glm::uvec3(10))), 0.999);
}

TEST(BoundedHull, OfOnePointOrAFlatSetHasNoFaces)
{
    const Vertex one{{1, 2, 3}, {0, 0, 1}, {0, 0}};
    const CollisionProxy point = collision_proxy(ProxyKind::bounded_hull, {&one, 1});
    EXPECT_EQ(point.points, (std::vector<glm::vec3>{{1, 2, 3}}));
    EXPECT_TRUE(hull_faces(point.points).empty());
    std::vector<Vertex> square;
    for (int i = 0; i < 16; ++i) square.push_back({{i % 4, i / 4, 7}, {0, 0, 1}, {0, 0}});
    const CollisionProxy flat = collision_proxy(ProxyKind::bounded_hull, square);
    EXPECT_EQ(flat.points.size(), 4u);
    EXPECT_TRUE(hull_faces(flat.points).empty());
}

TEST(BoundedHull, HasTheFirstPointOfEachPlaceInTheOrderOfTheDirections)
{
    for (const std::string& name : shapes::names()) {
        SCOPED_TRACE(name);
        const TriangleSoup soup = *shapes::make(name, 500, 1);
        std::vector<glm::vec3> places;
        for (const glm::vec3& p : brute_force(soup.vertices))
            if (std::count(places.begin(), places.end(), p) == 0) places.push_back(p);
        EXPECT_EQ(collision_proxy(ProxyKind::bounded_hull, soup.vertices).points, places);
    }
}

TEST(HullFaces, AreThoseOfTheConvexHullOverTheGivenPoints)
{
    // A cube with its centre and the middle of a side, which are no corners.
    std::vector<glm::vec3> points{{0, 0, 0}, {0.5f, 0.5f, 0}};
    for (int i = 0; i < 8; ++i) points.emplace_back((i & 1) * 2 - 1, (i & 2) - 1, (i & 4) / 2 - 1);
    for (glm::vec3& p : points) p.z += 0.25f;
    const std::vector<Triangle> faces = hull_faces(points);
    EXPECT_EQ(faces.size(), 12u);
    double volume = 0.0;
    for (const Triangle& t : faces) {
        for (const std::uint32_t corner : t) EXPECT_GE(corner, 2u);
        volume += glm::dot(glm::dvec3(points[t[0]]), glm::cross(glm::dvec3(points[t[1]]), glm::dvec3(points[t[2]])));
    }
    EXPECT_NEAR(volume / 6.0, 8.0, 1e-5);
}

}  // namespace
}  // namespace kerf::core
