#include "common/geometry/disjoint_sets.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

namespace kerf::core {
namespace {

TEST(DisjointSets, EachElementIsItsOwnSetAtFirst)
{
    DisjointSets sets(4);
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, TheSmallestElementStandsForItsSet)
{
    DisjointSets sets(6);
    sets.unite(5, 3);
    sets.unite(3, 4);
    EXPECT_EQ(sets.find(5), 3u);
    sets.unite(4, 1);
    for (const std::uint32_t i : {1u, 3u, 4u, 5u}) EXPECT_EQ(sets.find(i), 1u);
    EXPECT_EQ(sets.find(0), 0u);
    EXPECT_EQ(sets.find(2), 2u);
}

TEST(DisjointSets, UnitingTwiceOrWithItselfChangesNothing)
{
    DisjointSets sets(3);
    sets.unite(2, 2);
    sets.unite(1, 2);
    sets.unite(2, 1);
    EXPECT_EQ(sets.find(0), 0u);
    EXPECT_EQ(sets.find(2), 1u);
}

TEST(DisjointSets, GrowByOneSetAtATime)
{
    DisjointSets sets(2);
    sets.unite(0, 1);
    EXPECT_EQ(sets.add(), 2u);
    EXPECT_EQ(sets.find(2), 2u);
    sets.unite(2, 1);
    EXPECT_EQ(sets.find(2), 0u);
    EXPECT_EQ(sets.size(), 3u);
    sets.clear();
    EXPECT_EQ(sets.size(), 0u);
    EXPECT_EQ(sets.add(), 0u);
}

/// Colours all elements anew for each union: slow, and obviously right.
std::vector<std::uint32_t> coloured(std::uint32_t n, const std::vector<std::pair<std::uint32_t, std::uint32_t>>& unions)
{
    std::vector<std::uint32_t> colours(n);
    for (std::uint32_t i = 0; i < n; ++i) colours[i] = i;
    for (const auto& [a, b] : unions) {
        const std::uint32_t from = std::max(colours[a], colours[b]), to = std::min(colours[a], colours[b]);
        std::replace(colours.begin(), colours.end(), from, to);
    }
    return colours;
}

RC_GTEST_PROP(DisjointSets, AreTheSetsThatColouringGivesInWhateverOrder, ())
{
    const auto n = *rc::gen::inRange(1u, 60u);
    auto unions = *rc::gen::container<std::vector<std::pair<std::uint32_t, std::uint32_t>>>(
        rc::gen::pair(rc::gen::inRange(0u, n), rc::gen::inRange(0u, n)));
    const std::vector<std::uint32_t> expected = coloured(n, unions);
    for (const bool backwards : {false, true}) {
        if (backwards) std::reverse(unions.begin(), unions.end());
        DisjointSets sets(n);
        for (const auto& [a, b] : unions) sets.unite(a, b);
        for (std::uint32_t i = 0; i < n; ++i) RC_ASSERT(sets.find(i) == expected[i]);
    }
}

}  // namespace
}  // namespace kerf::core
