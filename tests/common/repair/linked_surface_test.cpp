#include "common/repair/linked_surface.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <utility>

#include "common/mesh/index.h"
#include "common/repair/triangle_faults.h"
#include "common/shapes/shapes.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

using namespace small_meshes;

constexpr std::uint32_t kPoints = 8;

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// The half-edges along each pair of points, by direction.
std::map<DirectedEdge, std::vector<std::uint32_t>> by_direction(const Buffer<Triangle>& corners)
{
    std::map<DirectedEdge, std::vector<std::uint32_t>> all;
    for (std::uint32_t h = 0; h < 3 * corners.size(); ++h)
        all[{corners[h / 3][h % 3], corners[h / 3][(h + 1) % 3]}].push_back(h);
    return all;
}

/// Empty if any directed edge occurs twice.
Buffer<std::uint32_t> opposite_by_the_rule(const Buffer<Triangle>& corners)
{
    const auto all = by_direction(corners);
    Buffer<std::uint32_t> opposite(3 * corners.size(), kNone);
    for (const auto& [edge, halfedges] : all) {
        if (halfedges.size() > 1) return {};
        const auto back = all.find({edge.second, edge.first});
        if (back != all.end()) opposite[halfedges.front()] = back->second.front();
    }
    return opposite;
}

Buffer<std::uint32_t> linked_plainly(std::uint32_t point_count, const Buffer<Triangle>& corners)
{
    HalfedgesByEdge edges(point_count, corners);
    Buffer<std::uint32_t> opposite;
    if (!link_plainly(corners, edges, opposite)) opposite.clear();
    return opposite;
}

TEST(LinkPlainly, LinksWhatHasEachDirectedEdgeOnce)
{
    const TriangleSoup asteroid = shapes::asteroid(500, 1);
    const auto point_count = static_cast<std::uint32_t>(asteroid.vertices.size());
    Buffer<Triangle> corners = asteroid.triangles;
    EXPECT_EQ(linked_plainly(point_count, corners), opposite_by_the_rule(corners));
    corners.resize(corners.size() / 2);  // open now
    const Buffer<std::uint32_t> opposite = linked_plainly(point_count, corners);
    EXPECT_FALSE(opposite.empty());
    EXPECT_EQ(opposite, opposite_by_the_rule(corners));
}

TEST(LinkPlainly, LinksExactlyWhatHasNoFaultAndNothingToDecide)
{
    // A few of all triangles over eight points: plain ones, repeats, backs, crowded edges and such that disagree.
    std::mt19937 random(20);
    std::size_t plain = 0, others = 0;
    for (int round = 0; round < 20'000; ++round) {
        Buffer<Triangle> corners(2 + random() % 5);
        for (Triangle& t : corners) {
            const std::uint32_t a = random() % kPoints, b = (a + 1 + random() % 3) % kPoints,
                                c = (a + 4 + random() % 4) % kPoints;
            t = random() % 2 ? Triangle{a, b, c} : Triangle{b, a, c};
        }
        const Buffer<std::uint32_t> expected = opposite_by_the_rule(corners);
        ASSERT_EQ(linked_plainly(kPoints, corners), expected);
        ++(expected.empty() ? others : plain);
        if (expected.empty()) continue;

        EXPECT_EQ(find_faults(kPoints, corners).repeats, 0u);
        std::vector<NonmanifoldEdge> resolved;
        HalfedgesByEdge edges(kPoints, corners);
        const std::vector<glm::vec3> positions(kPoints);
        const LinkedSurface surface = link_surface(corners, edges, positions, resolved);
        EXPECT_TRUE(resolved.empty());
        EXPECT_EQ(surface.opposite, expected);
        EXPECT_EQ(surface.corners, corners);
        EXPECT_EQ(surface.unorientable_edges + surface.nonmanifold_edges, 0u);
    }
    EXPECT_GT(plain, 1000u);
    EXPECT_GT(others, 1000u);
}

}  // namespace
}  // namespace kerf::core
