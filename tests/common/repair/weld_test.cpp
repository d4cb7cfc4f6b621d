#include "common/repair/weld.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace kerf::core {
namespace {

using Numbers = std::vector<std::uint32_t>;

Vertex vertex_at(const glm::vec3& position, const glm::vec3& normal = {0, 0, 1}, const glm::vec2& uv = {0, 0})
{
    return {position, normal, uv};
}

Numbers points_of(const std::vector<Vertex>& vertices)
{
    const Weld weld = weld_positions(vertices);
    return {weld.points.begin(), weld.points.end()};
}

Numbers first_equal(const std::vector<Vertex>& vertices, const std::vector<VertexStream>& streams = {},
                    bool ignore_normals = false)
{
    const Buffer<std::uint32_t> first =
        first_equal_vertices(weld_positions(vertices), vertices, streams, ignore_normals);
    return {first.begin(), first.end()};
}

VertexStream stream(std::uint32_t width, const std::vector<float>& values)
{
    return {"s", width, Buffer<float>(values.begin(), values.end())};
}

TEST(WeldPositions, NumbersPlacesInTheOrderInWhichTheyOccur)
{
    const std::vector<Vertex> vertices{vertex_at({5, 0, 0}), vertex_at({1, 0, 0}), vertex_at({5, 0, 0}),
                                       vertex_at({2, 0, 0}), vertex_at({1, 0, 0})};
    EXPECT_EQ(points_of(vertices), (Numbers{0, 1, 0, 2, 1}));
    EXPECT_EQ(weld_positions(vertices).point_count, 3u);
}

TEST(WeldPositions, NothingHasNoPlaces)
{
    EXPECT_EQ(weld_positions({}).point_count, 0u);
}

TEST(WeldPositions, MinusZeroIsZeroOnEachAxis)
{
    EXPECT_EQ(
        points_of({vertex_at({0, 0, 0}), vertex_at({-0.0f, 0, 0}), vertex_at({0, -0.0f, 0}), vertex_at({0, 0, -0.0f})}),
        (Numbers{0, 0, 0, 0}));
}

TEST(WeldPositions, NoToleranceNeighbouringFloatsAreTwoPlaces)
{
    const float next = std::nextafter(1.0f, 2.0f), tiny = std::numeric_limits<float>::denorm_min();
    EXPECT_EQ(
        points_of({vertex_at({1, 0, 0}), vertex_at({next, 0, 0}), vertex_at({1, tiny, 0}), vertex_at({1, 0, -tiny})}),
        (Numbers{0, 1, 2, 3}));
}

TEST(WeldPositions, WhatElseAVertexHasDoesNotMatter)
{
    EXPECT_EQ(points_of({vertex_at({1, 2, 3}, {1, 0, 0}, {0, 0}), vertex_at({1, 2, 3}, {0, 1, 0}, {1, 1})}),
              (Numbers{0, 0}));
}

/// A few places, so that many vertices share one.
rc::Gen<Vertex> crowded_vertex()
{
    const auto coordinate = rc::gen::element(-1.0f, -0.0f, 0.0f, 1.0f);
    return rc::gen::map(rc::gen::tuple(coordinate, coordinate, coordinate, coordinate), [](const auto& v) {
        const auto& [x, y, z, u] = v;
        return vertex_at({x, y, z}, {0, 0, 1}, {u + 0.0f, 0.0f});
    });
}

RC_GTEST_PROP(WeldPositions, TwoVerticesShareAPointExactlyIfTheirPositionsAreEqual, ())
{
    const auto vertices = *rc::gen::container<std::vector<Vertex>>(crowded_vertex());
    const Numbers points = points_of(vertices);
    for (std::size_t a = 0; a < vertices.size(); ++a)
        for (std::size_t b = 0; b < vertices.size(); ++b)
            RC_ASSERT((points[a] == points[b]) == (vertices[a].position == vertices[b].position));
}

TEST(FirstEqualVertices, AreTheFirstOfThoseWithThePlaceNormalAndUv)
{
    const glm::vec3 p{1, 2, 3};
    EXPECT_EQ(
        first_equal({vertex_at(p), vertex_at(p, {1, 0, 0}), vertex_at(p, {0, 0, 1}, {0.5f, 0}), vertex_at(p, {1, 0, 0}),
                     vertex_at(p), vertex_at(p, {0, 0, 1}, {0.5f, 0}), vertex_at({9, 9, 9})}),
        (Numbers{0, 1, 2, 1, 0, 2, 6}));
}

TEST(FirstEqualVertices, NormalsMayBeIgnored)
{
    const glm::vec3 p{1, 2, 3};
    EXPECT_EQ(first_equal({vertex_at(p), vertex_at(p, {1, 0, 0}), vertex_at(p, {1, 0, 0}, {0.5f, 0})}, {}, true),
              (Numbers{0, 0, 2}));
}

TEST(FirstEqualVertices, AllValuesOfAllStreamsCount)
{
    const std::vector<Vertex> vertices(4, vertex_at({1, 2, 3}));
    EXPECT_EQ(first_equal(vertices, {stream(2, {1, 2, 1, 3, 1, 2, 1, 3})}), (Numbers{0, 1, 0, 1}));
    EXPECT_EQ(first_equal(vertices, {stream(1, {1, 1, 1, 1}), stream(1, {0, 0, 0, 4})}), (Numbers{0, 0, 0, 3}));
}

TEST(FirstEqualVertices, EverythingButPositionsIsComparedByItsBits)
{
    const glm::vec3 p{1, 2, 3};
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(first_equal({vertex_at(p), vertex_at(p, {0, 0, 1}, {-0.0f, 0})}), (Numbers{0, 1}));
    const std::vector<Vertex> vertices(2, vertex_at(p));
    EXPECT_EQ(first_equal(vertices, {stream(1, {nan, nan})}), (Numbers{0, 0}));
    EXPECT_EQ(first_equal(vertices, {stream(1, {0.0f, -0.0f})}), (Numbers{0, 1}));
}

RC_GTEST_PROP(FirstEqualVertices, ComparingAllWithAllGivesTheSame, ())
{
    const auto vertices = *rc::gen::container<std::vector<Vertex>>(crowded_vertex());
    const Numbers first = first_equal(vertices);
    for (std::uint32_t v = 0; v < vertices.size(); ++v) {
        std::uint32_t expected = 0;
        while (vertices[expected].position != vertices[v].position || vertices[expected].uv != vertices[v].uv)
            ++expected;
        RC_ASSERT(first[v] == expected);
    }
}

}  // namespace
}  // namespace kerf::core
