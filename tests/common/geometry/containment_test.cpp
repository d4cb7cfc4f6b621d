#include "common/geometry/containment.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace kerf::core {
namespace {

using Numbers = std::vector<std::uint32_t>;

/// A cube about a point of the x axis; its size is its volume.
ContainableShape item_at(float centre, float half)
{
    ContainableShape item;
    item.box.add({centre - half, -half, -half});
    item.box.add({centre + half, half, half});
    item.size = 8.0 * half * half * half;
    return item;
}

/// As if everything filled its box: what is in the box is in it.
void boxes_decide(std::uint32_t, std::span<const std::uint32_t>, std::span<std::uint8_t> lies_in)
{
    for (std::uint8_t& lies : lies_in) lies = 1;
}

TEST(SmallestContainers, NothingOrOneThingLiesNowhere)
{
    EXPECT_TRUE(smallest_containers({}, boxes_decide).empty());
    EXPECT_EQ(smallest_containers(std::vector{item_at(0, 1)}, boxes_decide), Numbers{kNoContainer});
}

TEST(SmallestContainers, OfNestedBoxesEachLiesInTheNextLarger)
{
    const std::vector<ContainableShape> dolls{item_at(0, 3), item_at(0, 1), item_at(0, 4), item_at(0, 2)};
    EXPECT_EQ(smallest_containers(dolls, boxes_decide), (Numbers{2, 3, kNoContainer, 0}));
}

TEST(SmallestContainers, BesideAndAcrossIsNotIn)
{
    const std::vector<ContainableShape> items{item_at(0, 1), item_at(5, 1), item_at(0.75f, 0.5f)};
    EXPECT_EQ(smallest_containers(items, boxes_decide), (Numbers(3, kNoContainer)));
}

TEST(SmallestContainers, WhatIsDecidedCountsAndNotTheBox)
{
    const std::vector<ContainableShape> items{item_at(0, 3), item_at(0, 2), item_at(0, 1)};
    const auto not_in_the_middle_one = [](std::uint32_t container, std::span<const std::uint32_t>,
                                          std::span<std::uint8_t> lies_in) {
        for (std::uint8_t& lies : lies_in) lies = container != 1;
    };
    EXPECT_EQ(smallest_containers(items, not_in_the_middle_one), (Numbers{kNoContainer, 0, 0}));
}

TEST(SmallestContainers, OnlyWhatMayContainContainsAndOnlyWhatMayLieLies)
{
    std::vector<ContainableShape> items{item_at(0, 3), item_at(0, 2), item_at(0, 1)};
    items[1].can_contain = false;
    EXPECT_EQ(smallest_containers(items, boxes_decide), (Numbers{kNoContainer, 0, 0}));
    items[2].can_lie_in = false;
    EXPECT_EQ(smallest_containers(items, boxes_decide), (Numbers{kNoContainer, 0, kNoContainer}));
}

TEST(SmallestContainers, OfTwoAtOnePlaceTheOneThatCanContainDoes)
{
    for (const bool first_contains : {true, false}) {
        std::vector<ContainableShape> items{item_at(0, 1), item_at(0, 1)};
        items[0].can_contain = first_contains;
        items[1].can_contain = !first_contains;
        const std::uint32_t outer = first_contains ? 0 : 1;
        Numbers expected(2, kNoContainer);
        expected[1 - outer] = outer;
        EXPECT_EQ(smallest_containers(items, boxes_decide), expected);
    }
}

RC_GTEST_PROP(SmallestContainers, AreTheSmallestOfAllThatEnclose, ())
{
    // Different sizes and boxes that decide: a search over all pairs says the same.
    const auto n = *rc::gen::inRange(2u, 40u);
    std::vector<ContainableShape> items;
    for (std::uint32_t i = 0; i < n; ++i)
        items.push_back(item_at(float(*rc::gen::inRange(-20, 20)), 1.0f + 0.5f * float(*rc::gen::inRange(0, 30))));
    for (std::uint32_t i = 0; i < n; ++i) items[i].size += 1e-6 * i;
    const Numbers container = smallest_containers(items, boxes_decide);
    for (std::uint32_t i = 0; i < n; ++i) {
        std::uint32_t expected = kNoContainer;
        for (std::uint32_t outer = 0; outer < n; ++outer)
            if (outer != i && items[outer].size > items[i].size && encloses(items[outer].box, items[i].box) &&
                (expected == kNoContainer || items[outer].size < items[expected].size))
                expected = outer;
        RC_ASSERT(container[i] == expected);
    }
}

TEST(WindingNumbers, TheMostOfItsSamplesDecidesForACandidate)
{
    const std::vector<WindingSample> samples{{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{9, 0, 0}, 0},
                                             {{0, 1, 0}, 1}, {{8, 0, 0}, 1}, {{9, 1, 0}, 1}};
    WindingNumbers windings(samples);
    windings.add(item_at(0, 2).box, [](const glm::vec3&) { return 1; });
    std::vector<std::uint8_t> lies_in(2);
    windings.vote(lies_in);
    EXPECT_EQ(lies_in, (std::vector<std::uint8_t>{1, 0}));
}

TEST(WindingNumbers, WhatWindsBackAgainIsNotAround)
{
    const std::vector<WindingSample> samples{{{0, 0, 0}, 0}};
    for (const int second : {-1, 1}) {
        WindingNumbers windings(samples);
        windings.add(item_at(0, 2).box, [](const glm::vec3&) { return 1; });
        windings.add(item_at(0, 3).box, [&](const glm::vec3&) { return second; });
        std::vector<std::uint8_t> lies_in(1);
        windings.vote(lies_in);
        EXPECT_EQ(lies_in[0], second == 1 ? 1 : 0);
    }
}

TEST(WindingNumbers, OnlySamplesInReachAreAsked)
{
    const std::vector<WindingSample> samples{{{0, 0, 0}, 0}, {{5, 0, 0}, 1}};
    WindingNumbers windings(samples);
    std::vector<glm::vec3> asked;
    windings.add(item_at(5, 1).box, [&](const glm::vec3& position) {
        asked.push_back(position);
        return 1;
    });
    EXPECT_EQ(asked, (std::vector<glm::vec3>{{5, 0, 0}}));
}

TEST(WindingNumbers, WithAsManySamplesInAsOutItLiesOutside)
{
    const std::vector<WindingSample> samples{{{0, 0, 0}, 0}, {{5, 0, 0}, 0}};
    WindingNumbers windings(samples);
    windings.add(item_at(5, 1).box, [](const glm::vec3&) { return 2; });
    std::vector<std::uint8_t> lies_in(1);
    windings.vote(lies_in);
    EXPECT_EQ(lies_in[0], 0);
}

}  // namespace
}  // namespace kerf::core
