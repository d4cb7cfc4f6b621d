#include "common/repair/edge_runs.h"

#include <gtest/gtest.h>

#include <map>

#include "common/repair/mesh_facts.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/small_meshes.h"

namespace kerf {
namespace {

using namespace small_meshes;

TEST(EdgeRuns, BringTheHalfEdgesOfEachEdgeTogetherInOrder)
{
    const TriangleSoup mesh = cube() + cube();  // cube() twice at the same vertices
    Buffer<Triangle> corners = mesh.triangles;
    for (Triangle& triangle : corners)
        for (std::uint32_t& point : triangle) point %= 8;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<std::uint32_t>> expected;
    for (std::uint32_t h = 0; h < 3 * corners.size(); ++h)
        expected[std::minmax(corners[h / 3][h % 3], corners[h / 3][(h + 1) % 3])].push_back(h);
    auto next = expected.begin();
    EdgeRuns(8, corners).for_each([&](std::span<const EdgeRuns::Side> edge) {
        ASSERT_NE(next, expected.end());
        ASSERT_EQ(edge.size(), next->second.size());
        for (std::size_t i = 0; i < edge.size(); ++i) {
            EXPECT_EQ(edge[i].half_edge, next->second[i]);
            EXPECT_EQ(edge[i].larger_point, next->first.second);
        }
        ++next;
    });
    EXPECT_EQ(next, expected.end());
}

TEST(EdgeRuns, SortTheHubOfALargeFanToo)
{
    const IndexedMesh cone = *repair(shapes::cone(1.0f, 1.0f, 1000)).mesh;
    for (const std::uint32_t twin : half_edge_twins(cone)) ASSERT_NE(twin, kNoTwin);
}

TEST(HalfEdgeTwins, RunAlongTheSamePointsTheOtherWay)
{
    const IndexedMesh mesh = *repair(cube()).mesh;
    const Buffer<std::uint32_t> twins = half_edge_twins(mesh);
    const auto point = [&](std::uint32_t h) { return mesh.points[mesh.triangles[h / 3][h % 3]]; };
    for (std::uint32_t h = 0; h < twins.size(); ++h) {
        ASSERT_NE(twins[h], kNoTwin);
        EXPECT_EQ(twins[twins[h]], h);
        EXPECT_EQ(point(h), point(next_half_edge(twins[h])));
        EXPECT_EQ(point(next_half_edge(h)), point(twins[h]));
    }
}

TEST(HalfEdgeTwins, AreMissingAtTheBoundary)
{
    const IndexedMesh mesh = *repair(moebius_strip(24)).mesh;
    const Buffer<std::uint32_t> twins = half_edge_twins(mesh);
    EXPECT_EQ(static_cast<std::uint64_t>(std::count(twins.begin(), twins.end(), kNoTwin)),
              measure(mesh).boundary_edges);
}

}  // namespace
}  // namespace kerf
