#include "common/repair/adjacency.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <random>
#include <utility>

#include "common/geometry/disjoint_sets.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/coinciding_solids.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

using namespace small_meshes;

/// By the words of the promise: two half-edges are opposite if they run along the same two points the other way round,
/// shells are what is connected so.
void expect_right(const ProvenMesh& mesh)
{
    const Adjacency& adjacency = mesh.adjacency();
    const auto n = static_cast<Index>(mesh->triangles.size());
    ASSERT_EQ(adjacency.opposite.size(), 3 * n);
    ASSERT_EQ(adjacency.shell.size(), n);
    const auto point = [&](Index h) { return mesh->points[mesh->triangles[h / 3][h % 3]]; };
    std::map<std::pair<Index, Index>, Index> leaving;
    for (Index h = 0; h < 3 * n; ++h) leaving[{point(h), point(h % 3 == 2 ? h - 2 : h + 1)}] = h;
    DisjointSets connected(n);
    for (Index h = 0; h < 3 * n; ++h) {
        const auto found = leaving.find({point(h % 3 == 2 ? h - 2 : h + 1), point(h)});
        ASSERT_EQ(adjacency.opposite[h], found == leaving.end() ? kNone : found->second) << h;
        if (found != leaving.end()) connected.unite(h / 3, found->second / 3);
    }
    std::map<std::uint32_t, Index> number;
    for (Index t = 0; t < n; ++t) {
        const Index expected = number.try_emplace(connected.find(t), Index(number.size())).first->second;
        ASSERT_EQ(adjacency.shell[t], expected) << t;
    }
    EXPECT_EQ(adjacency.shell_count, number.size());
}

TEST(Adjacency, IsThatOfThePointsOfARepairedMesh)
{
    for (const std::string& name : shapes::names()) {
        SCOPED_TRACE(name);
        expect_right(repair(*shapes::make(name, 1000, 1)).mesh);
    }
    for (const TriangleSoup& soup : {cube(), cube() + cube(), moebius_strip(24)}) expect_right(repair(soup).mesh);
}

/// Many triangles on few points: edges with any number of triangles, points with many fans, Moebius strips.
TEST(Adjacency, IsThatOfThePointsWhateverMeets)
{
    std::mt19937 random(20261124);
    for (int round = 0; round < 400; ++round) {
        SCOPED_TRACE(round);
        const auto below = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(random() % bound); };
        TriangleSoup soup;
        const std::uint32_t points = 4 + below(12);
        for (std::uint32_t v = 0; v < points; ++v)
            soup.vertices.push_back({glm::vec3(float(below(97)), float(below(97)), float(below(97))), {}, {}});
        soup.has_normals = false;
        for (std::uint32_t t = 1 + below(60); t > 0; --t)
            soup.triangles.push_back({below(points), below(points), below(points)});
        const Repaired repaired = repair(soup);
        if (repaired.error.empty()) expect_right(repaired.mesh);
    }
    for (int round = 0; round < 50; ++round) {
        SCOPED_TRACE(round);
        TriangleSoup soup = solids_with_common_triangles(random);
        turn_some_over(soup, random);
        expect_right(repair(soup).mesh);
    }
}

TEST(Adjacency, IsThatOfThePointsOfAMeshThatWasProven)
{
    for (const TriangleSoup& soup : {cube() + cube(), moebius_strip(24)}) expect_right(prove(*repair(soup).mesh).mesh);
}

TEST(Adjacency, EndsWithTheMeshThatIsTakenOut)
{
    ProvenMesh proven = repair(cube()).mesh;
    ProvenMesh copy = proven, moved = std::move(proven);
    EXPECT_EQ(copy.adjacency().opposite, moved.adjacency().opposite);
    const IndexedMesh mesh = *std::move(copy);
    EXPECT_EQ(mesh.triangles.size(), 12u);
    // NOLINTNEXTLINE(bugprone-use-after-move): that is what is tested
    EXPECT_TRUE(copy.adjacency().opposite.empty());
}

TEST(Adjacency, FollowsTheOrderOfTriangles)
{
    const ProvenMesh mesh = repair(cube() + cube()).mesh;
    const Adjacency& adjacency = mesh.adjacency();
    std::vector<Index> order(mesh->triangles.size());
    std::iota(order.rbegin(), order.rend(), Index(0));
    const Adjacency turned = adjacency_in_order(adjacency.opposite, adjacency.shell, order);
    const auto n = static_cast<Index>(order.size());
    for (Index h = 0; h < 3 * n; ++h) {
        const Index old = adjacency.opposite[3 * order[h / 3] + h % 3];
        EXPECT_EQ(turned.opposite[h], 3 * (n - 1 - old / 3) + old % 3);
    }
    EXPECT_EQ(turned.shell.front(), 0u);
    EXPECT_EQ(turned.shell_count, adjacency.shell_count);
}

}  // namespace
}  // namespace kerf::core
