#include <kerf/kerf.h>
#include <kerf/proxy.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <thread>
#include <utility>
#include <vector>

#include "api/objects.h"

// Hulls as programs see them.

namespace kerf {
namespace {

Object object_of(const char* shape, std::uint64_t triangles)
{
    return test::object_of(test::shape(shape, triangles), test::back_end_names().front());
}

/// Whether each edge has a triangle on either side.
bool is_closed(std::span<const std::uint32_t> indices)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t i = 0; i < indices.size(); i += 3)
        for (std::size_t j = 0; j < 3; ++j) {
            const std::uint32_t a = indices[i + j], b = indices[i + (j + 1) % 3];
            edges[std::minmax(a, b)] += a < b ? 1 : -1;
        }
    return std::ranges::all_of(edges, [](const auto& edge) { return edge.second == 0; });
}

}  // namespace

TEST(Hull, OfWhateverKindIsSpannedByDifferentVerticesAndIsClosed)
{
    const Object object = object_of("asteroid", 2000);
    const Result<Mesh> mesh = object.mesh();
    ASSERT_TRUE(mesh);
    const std::span<const Vec3f> vertices = mesh->arrays().positions;
    for (const auto make : {bounded_hull, full_hull}) {
        const Result<Hull> hull = make(object);
        ASSERT_TRUE(hull);
        const std::span<const Vec3f> points = hull->points();
        for (std::size_t i = 0; i < points.size(); ++i) {
            EXPECT_NE(std::ranges::find(vertices, points[i]), vertices.end());
            EXPECT_EQ(std::ranges::count(points, points[i]), 1);
        }
        ASSERT_GE(hull->indices().size(), 12u);
        for (const std::uint32_t corner : hull->indices()) ASSERT_LT(corner, points.size());
        EXPECT_TRUE(is_closed(hull->indices()));
    }
}

TEST(Hull, FindsItsTrianglesOnce)
{
    const Hull hull = *bounded_hull(object_of("icosphere", 320));
    const std::span<const std::uint32_t> first = hull.indices();
    EXPECT_EQ(first.data(), hull.indices().data());
    EXPECT_EQ(first.size(), hull.indices().size());
}

TEST(Hull, GivesEveryThreadTheSameTriangles)
{
    const Hull hull = *bounded_hull(object_of("icosphere", 320));
    std::vector<std::span<const std::uint32_t>> seen(4);
    {
        std::vector<std::jthread> threads;
        for (auto& each : seen) threads.emplace_back([&] { each = hull.indices(); });
    }
    for (const auto& each : seen) {
        EXPECT_EQ(each.data(), hull.indices().data());
        EXPECT_EQ(each.size(), hull.indices().size());
    }
}

TEST(Hull, ThatIsEmptyOrMovedFromHasNothing)
{
    Hull hull = *bounded_hull(object_of("box", 12));
    EXPECT_EQ(hull.points().size(), 8u);
    EXPECT_EQ(hull.indices().size(), 36u);
    const Hull taken = std::move(hull);
    EXPECT_EQ(taken.points().size(), 8u);
    const Hull never_made;
    // NOLINTNEXTLINE(bugprone-use-after-move): what is left of it is a promise of the header.
    for (const Hull* empty : {static_cast<const Hull*>(&hull), &never_made}) {
        EXPECT_TRUE(empty->points().empty());
        EXPECT_TRUE(empty->indices().empty());
    }
}

}  // namespace kerf
