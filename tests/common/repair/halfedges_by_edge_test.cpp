#include "common/repair/halfedges_by_edge.h"

#include <gtest/gtest.h>

#include <map>

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

}  // namespace
}  // namespace kerf::core
