#include "common/geometry/line_hits.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>

namespace kerf::core {
namespace {

std::optional<double> middle(std::vector<LineHit> hits)
{
    return middle_of_longest_inside(hits);
}

TEST(LineHits, TheLongestWayThroughTheInsideCounts)
{
    EXPECT_EQ(middle({{0.0, 1}, {2.0, -1}, {5.0, 1}, {9.0, -1}}), 7.0);
    EXPECT_EQ(middle({{9.0, -1}, {5.0, 1}, {2.0, -1}, {0.0, 1}}), 7.0) << "in whatever order they are found";
}

TEST(LineHits, AHoleDividesTheInside)
{
    EXPECT_EQ(middle({{0.0, 1}, {1.0, -1}, {8.0, 1}, {10.0, -1}}), 9.0);
}

TEST(LineHits, WhatIsWoundAroundTwiceOrBackwardsIsInside)
{
    EXPECT_EQ(middle({{0.0, 1}, {1.0, 1}, {7.0, -1}, {8.0, -1}}), 4.0);
    EXPECT_EQ(middle({{0.0, -1}, {4.0, 1}}), 2.0);
}

TEST(LineHits, WithoutAnInsideThereIsNoMiddle)
{
    EXPECT_EQ(middle({}), std::nullopt);
    EXPECT_EQ(middle({{3.0, 1}}), std::nullopt);
    EXPECT_EQ(middle({{3.0, 1}, {3.0, -1}}), std::nullopt) << "no length";
}

RC_GTEST_PROP(LineHits, TheMiddleIsInside, ())
{
    // Loops as pairs of hits, each wound around once, either way.
    const auto loops = *rc::gen::container<std::vector<std::array<int, 3>>>(
        rc::gen::container<std::array<int, 3>>(rc::gen::inRange(-50, 50)));
    std::vector<LineHit> hits;
    for (const auto& [a, b, direction] : loops) {
        const int turns = direction < 0 ? -1 : 1;
        hits.push_back({double(std::min(a, b)), turns});
        hits.push_back({double(std::max(a, b)), -turns});
    }
    const std::vector<LineHit> given = hits;
    const auto winding_at = [&](double place) {
        int winding = 0;
        for (const LineHit& hit : given)
            if (hit.place < place) winding += hit.turns;
        return winding;
    };
    const std::optional<double> found = middle_of_longest_inside(hits);
    bool any_inside = false;
    for (int i = -50; i < 50; ++i) any_inside = any_inside || winding_at(i + 0.5) != 0;
    RC_ASSERT(found.has_value() == any_inside);
    if (found) {
        RC_ASSERT(winding_at(*found) != 0);
    }
}

}  // namespace
}  // namespace kerf::core
