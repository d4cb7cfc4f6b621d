#include "common/cutting/cut_geometry.h"

#include <gtest/gtest.h>

#include <rapidcheck/gtest.h>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

namespace kerf::core {
namespace {

using Corners = std::array<glm::vec3, 3>;

glm::vec3 position_of(const TriangleSplit& split, const Corners& p, std::uint8_t code)
{
    if (code == TriangleSplit::kCutNext) return split.cut_next.position;
    if (code == TriangleSplit::kCutPrevious) return split.cut_previous.position;
    return p[code];
}

glm::dvec3 area_vector(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    return glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a)) * 0.5;
}

/// Small integers make coincidences and vertices on the plane frequent.
rc::Gen<glm::vec3> small_point()
{
    // A fixed size: RapidCheck's first cases are otherwise all zero.
    const auto coordinate = rc::gen::resize(rc::kNominalSize, rc::gen::inRange(-4, 5));
    return rc::gen::map(rc::gen::container<std::vector<int>>(3, coordinate),
                        [](const std::vector<int>& v) { return glm::vec3(float(v[0]), float(v[1]), float(v[2])); });
}

std::array<double, 3> distances(const Plane& plane, const Corners& p)
{
    return {plane.signed_distance(p[0]), plane.signed_distance(p[1]), plane.signed_distance(p[2])};
}

TEST(CutEdge, GivesTheSameBitsFromBothEnds)
{
    const glm::vec3 a{0.1f, 0.7f, -0.3f}, b{-1.3f, 0.2f, 0.9f};
    const CutPoint ab = cut_edge(a, 0.3, b, -1.1), ba = cut_edge(b, -1.1, a, 0.3);
    EXPECT_EQ(ab.position, ba.position);
    EXPECT_EQ(ab.t, ba.t);
    EXPECT_NE(ab.swapped, ba.swapped);
}

TEST(CutEdge, ReturnsAnEndPointOnThePlaneItself)
{
    const glm::vec3 a{0.1f, 0.7f, -0.3f}, b{-1.3f, 0.2f, 0.9f};
    EXPECT_EQ(cut_edge(a, 0.0, b, -1.1).position, a);
    EXPECT_EQ(cut_edge(b, -1.1, a, 0.0).position, a);
}

TEST(CutEdge, StaysInsideTheBoxOfItsEndPoints)
{
    const glm::vec3 a{1.0f, 1.0f, 1.0f}, b{std::nextafter(1.0f, 2.0f), 1.0f, 3.0f};
    const glm::vec3 p = cut_edge(a, -1.0, b, 1e-9).position;
    EXPECT_GE(p.x, a.x);
    EXPECT_LE(p.x, b.x);
    EXPECT_EQ(p.y, 1.0f);
}

TEST(CutEdge, NeverGivesNegativeZero)
{
    const glm::vec3 p = cut_edge({-1, 0, 0}, -1.0, {1, 0, 0}, 1.0).position;
    EXPECT_FALSE(std::signbit(p.x));
}

TEST(Interpolate, RenormalisesNormalsAndFollowsT)
{
    const Vertex a{{0, 0, 0}, {1, 0, 0}, {0, 0}}, b{{4, 0, 0}, {0, 1, 0}, {1, 2}};
    const Vertex v = interpolate(cut_edge(a.position, -1, b.position, 3), a, b);
    EXPECT_EQ(v.position, glm::vec3(1, 0, 0));
    EXPECT_NEAR(glm::length(v.normal), 1.0f, 1e-6f);
    EXPECT_EQ(v.uv, glm::vec2(0.25f, 0.5f));
}

TEST(SplitTriangle, AnOrdinaryCrossingMakesThreePieces)
{
    const Corners p{glm::vec3{0, 0, 1}, glm::vec3{2, 0, -1}, glm::vec3{-2, 0, -1}};
    const TriangleSplit split = split_triangle(p, {1, -1, -1});
    EXPECT_EQ(split.sub_triangle_count, 3);
    EXPECT_EQ(split.lone, 0);
    EXPECT_EQ(split.lone_side, Side::positive);
    EXPECT_EQ(split.cut_next.position, glm::vec3(1, 0, 0));
    EXPECT_EQ(split.cut_previous.position, glm::vec3(-1, 0, 0));
}

TEST(SplitTriangle, ACornerOnThePlaneMakesTwoPieces)
{
    const Corners p{glm::vec3{0, 0, 0}, glm::vec3{2, 0, 1}, glm::vec3{2, 0, -1}};
    const TriangleSplit split = split_triangle(p, {0, 1, -1});
    EXPECT_EQ(split.sub_triangle_count, 2);
}

TEST(SplitTriangle, APieceThatRoundsAwayLeavesTheTriangleWhole)
{
    // Corner 0 is so little above the plane z = 1 - 1e-12 that both cut points round to it.
    const Corners p{glm::vec3{5, 1, 1}, glm::vec3{6, 1, -1}, glm::vec3{4, 1, -1}};
    const TriangleSplit split = split_triangle(p, {1e-12, -2, -2});
    ASSERT_EQ(split.sub_triangle_count, 1);
    EXPECT_EQ(split.sub_triangle[0].side, Side::negative);
    EXPECT_FALSE(split.has_section_edge());
}

/// The boundary of the pieces, as directed edges counted with sign, is the triangle's own outline (with the cut points
/// on it): nothing is opened.
RC_GTEST_PROP(SplitTriangle, PiecesHaveTheTrianglesOutlineAndArea, ())
{
    const Corners p{*small_point(), *small_point(), *small_point()};
    const glm::vec3 normal = *small_point();
    RC_PRE(p[0] != p[1] && p[1] != p[2] && p[2] != p[0]);
    const auto plane = Plane::through({0.25, 0, 0}, normal);
    RC_PRE(plane.has_value());
    const auto d = distances(*plane, p);
    RC_PRE(classify(d[0], d[1], d[2]) == TriangleClass::crossing);

    const TriangleSplit split = split_triangle(p, d);
    RC_ASSERT(split.sub_triangle_count >= 1);
    std::map<std::pair<std::uint8_t, std::uint8_t>, int> edges;
    const auto run = [&](std::uint8_t from, std::uint8_t to, int sign) {
        if (from == to) return;
        edges[{from, to}] += sign;
        edges[{to, from}] -= sign;
    };
    glm::dvec3 area{0};
    for (int i = 0; i < split.sub_triangle_count; ++i) {
        const auto& c = split.sub_triangle[std::size_t(i)].corners;
        const glm::vec3 x = position_of(split, p, c[0]), y = position_of(split, p, c[1]),
                        z = position_of(split, p, c[2]);
        RC_ASSERT(x != y && y != z && z != x);
        area += area_vector(x, y, z);
        for (int k = 0; k < 3; ++k) run(c[std::size_t(k)], c[std::size_t((k + 1) % 3)], 1);
    }
    const std::uint8_t lone = split.lone, next = std::uint8_t((lone + 1) % 3), previous = std::uint8_t((lone + 2) % 3);
    run(lone, split.next_code, -1);
    run(split.next_code, next, -1);
    run(next, previous, -1);
    run(previous, split.previous_code, -1);
    run(split.previous_code, lone, -1);
    for (const auto& [edge, count] : edges) RC_ASSERT(count == 0);
    RC_ASSERT(glm::length(area - area_vector(p[0], p[1], p[2])) < 1e-5);
}

RC_GTEST_PROP(SplitTriangle, DoesNotDependOnTheFirstCorner, ())
{
    const Corners p{*small_point(), *small_point(), *small_point()};
    RC_PRE(p[0] != p[1] && p[1] != p[2] && p[2] != p[0]);
    const Plane plane = *Plane::through({0.1, 0.2, 0.3}, {1, 2, -1.5});
    const auto d = distances(plane, p);
    RC_PRE(classify(d[0], d[1], d[2]) == TriangleClass::crossing);
    const TriangleSplit s = split_triangle(p, d);
    const Corners turned{p[1], p[2], p[0]};
    const TriangleSplit t = split_triangle(turned, {d[1], d[2], d[0]});
    RC_ASSERT(s.sub_triangle_count == t.sub_triangle_count);
    for (std::size_t i = 0; i < s.sub_triangle_count; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            RC_ASSERT(position_of(s, p, s.sub_triangle[i].corners[k]) ==
                      position_of(t, turned, t.sub_triangle[i].corners[k]));
}

TEST(CoplanarSide, IsBehindTheTriangleWhicheverCornerComesFirst)
{
    const Plane plane = *Plane::through({0, 0, 0}, {0, 0, 1});
    const glm::vec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
    EXPECT_EQ(coplanar_side(plane, a, b, c), Side::negative);
    EXPECT_EQ(coplanar_side(plane, c, a, b), Side::negative);
    EXPECT_EQ(coplanar_side(plane, a, c, b), Side::positive);
    EXPECT_EQ(coplanar_side(plane, a, b, {2, 0, 0}), Side::positive);
    EXPECT_EQ(coplanar_side(plane.flipped(), a, b, {2, 0, 0}), Side::negative) << "a needle stays where it is";
}

}  // namespace
}  // namespace kerf::core
