#include "halfedge/cut/leaf_distances.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <span>

#include "common/support/processor.h"
#include "support/fixtures.h"

namespace kerf::core::halfedge {
namespace {

/// The triangles of a mesh in leaves of different sizes, with planes of all kinds, some of them through corners.
template <class Check>
void for_each_leaf(Check check)
{
    for (const auto& [name, mesh] : test::closed_shapes()) {
        SCOPED_TRACE(name);
        for (const auto& plane : test::planes_for(mesh, 2, 3)) {
            SCOPED_TRACE(plane.name);
            std::uint32_t count = 0;
            for (std::size_t first = 0; first < mesh.triangles.size(); first += count) {
                count = static_cast<std::uint32_t>(
                    std::min<std::size_t>(count % kMaxLeafTriangles + 1, mesh.triangles.size() - first));
                check(plane.plane, std::span<const Vertex>(mesh.vertices),
                      std::span<const Triangle>(mesh.triangles).subspan(first, count));
            }
        }
    }
}

void expect_distances(bool with_avx2)
{
    std::optional<WithoutAvx2> without;
    if (!with_avx2) without.emplace();
    std::size_t corners_on_a_plane = 0;
    LeafDistances distances;
    for_each_leaf([&](const Plane& plane, std::span<const Vertex> vertices, std::span<const Triangle> triangles) {
        distances.find(plane, vertices, triangles);
        const LeafDistances::Masks masks = distances.masks(triangles.size());
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            bool above = false, below = false, on = false;
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const double d = plane.signed_distance(vertices[triangles[i][corner]].position);
                ASSERT_EQ(distances.of(i)[corner], d);
                above |= d > 0.0;
                below |= d < 0.0;
                on |= d == 0.0;
                corners_on_a_plane += d == 0.0 ? 1 : 0;
            }
            ASSERT_EQ(distances.is_above(i), above);
            ASSERT_EQ(distances.is_below(i), below);
            ASSERT_EQ(distances.is_on(i), on);
            ASSERT_EQ(masks.crossing >> i & 1, above && below ? 1u : 0u);
            ASSERT_EQ(masks.on >> i & 1, on ? 1u : 0u);
            ASSERT_EQ(masks.above >> i & 1, above ? 1u : 0u);
        }
        ASSERT_EQ((masks.crossing | masks.on | masks.above) >> triangles.size(), 0u);
    });
    EXPECT_GT(corners_on_a_plane, 100u);
}

}  // namespace

TEST(LeafDistances, AreSignedDistancesBitForBitOneByOne)
{
    expect_distances(false);
}

TEST(LeafDistances, AreSignedDistancesBitForBitThreeAtOnce)
{
    if (!has_avx2()) GTEST_SKIP() << "this processor computes no four doubles at once";
    expect_distances(true);
}

}  // namespace kerf::core::halfedge
