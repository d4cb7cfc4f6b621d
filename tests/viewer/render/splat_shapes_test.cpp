#include "viewer/render/splat_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace kerf::test {

using render::SplatShapes;

namespace {

constexpr int kSide = SplatShapes::kSide;

const SplatShapes& shapes()
{
    static const SplatShapes made = render::make_splat_shapes();
    return made;
}

bool is_juice(int shape, int x, int y)
{
    return float(shapes().texel(shape, x, y)[0]) >= 255.0f * SplatShapes::kEdge;
}

/// Texels of each connected piece, largest first.
std::vector<int> sizes_of_pieces(int shape)
{
    std::vector<char> seen(std::size_t(kSide) * kSide, 0);
    std::vector<int> sizes;
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const auto at = [](int i, int j) { return std::size_t(j) * kSide + std::size_t(i); };
            if (seen[at(x, y)] || !is_juice(shape, x, y)) continue;
            int size = 0;
            std::queue<std::pair<int, int>> next;
            next.emplace(x, y);
            seen[at(x, y)] = 1;
            for (; !next.empty(); next.pop(), ++size) {
                const auto [i, j] = next.front();
                for (const auto& [u, v] : {std::pair{i - 1, j}, {i + 1, j}, {i, j - 1}, {i, j + 1}}) {
                    if (u < 0 || v < 0 || u >= kSide || v >= kSide || seen[at(u, v)] || !is_juice(shape, u, v))
                        continue;
                    seen[at(u, v)] = 1;
                    next.emplace(u, v);
                }
            }
            sizes.push_back(size);
        }
    std::sort(sizes.rbegin(), sizes.rend());
    return sizes;
}

}  // namespace

TEST(SplatShapes, AreABodyWithManyDroplets)
{
    for (int shape = 0; shape < SplatShapes::kShapes; ++shape) {
        SCOPED_TRACE(shape);
        const std::vector<int> pieces = sizes_of_pieces(shape);
        ASSERT_GT(pieces.size(), 30u);
        EXPECT_GT(pieces[0], 20 * pieces[1]) << "the body";
        EXPECT_TRUE(is_juice(shape, kSide / 2, kSide / 2));
        EXPECT_GT(pieces[pieces.size() / 2], 8) << "droplets are seen";
    }
}

TEST(SplatShapes, EndBeforeTheirSides)
{
    for (int shape = 0; shape < SplatShapes::kShapes; ++shape)
        for (int i = 0; i < kSide; ++i)
            for (const auto& [x, y] : {std::pair{i, 0}, {i, kSide - 1}, {0, i}, {kSide - 1, i}})
                ASSERT_EQ(shapes().texel(shape, x, y)[0], 0) << shape << ": " << x << ", " << y;
}

TEST(SplatShapes, SlopesAreThoseOfTheHeights)
{
    const float texels_a_radius = float(kSide) / (2.0f * SplatShapes::kReach);
    for (int y = 100; y < 400; y += 7)
        for (int x = 100; x < 400; x += 7) {
            const auto height = [&](int i, int j) { return float(shapes().texel(0, i, j)[0]) / 255.0f; };
            const float slope = 0.5f * (height(x + 1, y) - height(x - 1, y)) * texels_a_radius;
            const float stored = 2.0f * SplatShapes::kMostSlope * float(shapes().texel(0, x, y)[1] - 128) / 255.0f;
            // A height is rounded to 1/255, a slope to 16/255.
            if (std::abs(slope) < SplatShapes::kMostSlope) {
                ASSERT_NEAR(slope, stored, texels_a_radius / 255.0f + 0.07f) << x << ", " << y;
            }
        }
}

TEST(SplatShapes, AreTheSameEachTimeAndDifferFromEachOther)
{
    EXPECT_EQ(render::make_splat_shapes().texels, shapes().texels);
    const std::size_t bytes = shapes().texels.size() / SplatShapes::kShapes;
    EXPECT_FALSE(std::equal(shapes().texels.begin(), shapes().texels.begin() + std::ptrdiff_t(bytes),
                            shapes().texels.begin() + std::ptrdiff_t(bytes)));
}

}  // namespace kerf::test
