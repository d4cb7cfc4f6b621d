#include "common/repair/halfedges_by_edge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

using namespace small_meshes;

TEST(HalfedgesByEdge, BringsTheHalfEdgesOfEachEdgeTogetherInOrder)
{
    const TriangleSoup mesh = cube() + cube();  // cube() twice at the same vertices
    Buffer<Triangle> corners = mesh.triangles;
    for (Triangle& triangle : corners)
        for (std::uint32_t& point : triangle) point %= 8;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> expected;
    for (std::uint32_t h = 0; h < 3 * corners.size(); ++h)
        expected[std::minmax(corners[h / 3][h % 3], corners[h / 3][(h + 1) % 3])].push_back(h);
    auto next = expected.begin();
    HalfedgesByEdge(8, corners).for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
        ASSERT_NE(next, expected.end());
        ASSERT_EQ(edge.size(), next->second.size());
        for (std::size_t i = 0; i < edge.size(); ++i) {
            EXPECT_EQ(edge[i].halfedge, next->second[i]);
            EXPECT_EQ(edge[i].larger_point, next->first.second);
        }
        ++next;
    });
    EXPECT_EQ(next, expected.end());
}

TEST(HalfedgesByEdge, SortsTheHubOfALargeFanToo)
{
    const IndexedMesh cone = *repair(shapes::cone(1.0f, 1.0f, 1000)).mesh;
    Buffer<Triangle> corners = cone.triangles;
    for (Triangle& triangle : corners)
        for (std::uint32_t& corner : triangle) corner = cone.points[corner];
    HalfedgesByEdge(cone.point_count, corners).for_each([](std::span<const HalfedgesByEdge::Entry> edge) {
        ASSERT_EQ(edge.size(), 2u);
    });
}

TEST(HalfedgesByEdge, SortsThreeNeighboursThatAreMetInAnyOrder)
{
    // Three triangles around point 0, whose corners at points 1, 2 and 3 come in every order.
    std::array<Triangle, 3> fan{Triangle{0, 1, 2}, Triangle{0, 2, 3}, Triangle{0, 3, 1}};
    std::sort(fan.begin(), fan.end());
    do
        for (unsigned turns = 0; turns < 27; ++turns) {
            Buffer<Triangle> corners(fan.begin(), fan.end());
            const std::array<unsigned, 3> turn{turns % 3, turns / 3 % 3, turns / 9};
            for (std::size_t t = 0; t < 3; ++t)
                std::rotate(corners[t].begin(), corners[t].begin() + turn[t], corners[t].end());
            std::vector<std::pair<std::uint32_t, std::uint32_t>> at_hub;
            HalfedgesByEdge(4, corners).for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
                for (const auto& [larger, h] : edge)
                    if (corners[h / 3][h % 3] == 0 || corners[h / 3][(h + 1) % 3] == 0) at_hub.emplace_back(larger, h);
            });
            EXPECT_EQ(at_hub.size(), 6u);
            EXPECT_TRUE(std::is_sorted(at_hub.begin(), at_hub.end()));
        }
    while (std::next_permutation(fan.begin(), fan.end()));
}

TEST(HalfedgesByEdge, IsVisitedTheSameAgain)
{
    const TriangleSoup mesh = cube() + cube();
    HalfedgesByEdge edges(16, mesh.triangles);
    const auto visited = [&] {
        std::vector<std::uint32_t> halfedges;
        edges.for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
            for (const HalfedgesByEdge::Entry& entry : edge) halfedges.push_back(entry.halfedge);
        });
        return halfedges;
    };
    const auto first = visited();
    EXPECT_EQ(first.size(), 3 * mesh.triangles.size());
    EXPECT_EQ(first, visited());
}

TEST(HalfedgesByEdge, StopsAtTheEdgeThatSaysSo)
{
    const TriangleSoup mesh = cube();
    std::size_t visits = 0;
    EXPECT_FALSE(HalfedgesByEdge(8, mesh.triangles).for_each_while([&](auto) { return ++visits < 5; }));
    EXPECT_EQ(visits, 5u);
    EXPECT_TRUE(HalfedgesByEdge(8, mesh.triangles).for_each_while([](auto) { return true; }));
}

}  // namespace
}  // namespace kerf::core
