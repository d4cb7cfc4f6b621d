#include "viewer/game/combo.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "viewer/game/game_mode.h"

namespace kerf::game {
namespace {

// So many cuts of one swipe, one a tick from `start`.
void add(Combo& combo, int fruit, std::uint32_t swipe, sim::Tick start = 0)
{
    for (int i = 0; i < fruit; ++i) EXPECT_FALSE(combo.add(swipe, start + i, {double(i), 1.0}));
}

}  // namespace

TEST(Combo, IsThreeFruitOfOneSwipe)
{
    Combo combo;
    add(combo, 3, 1);
    EXPECT_EQ(combo.fruit(), 3);
    const auto closed = combo.close();
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->fruit, 3);
    EXPECT_EQ(closed->place, glm::dvec2(1.0, 1.0));
}

TEST(Combo, IsNotTwoFruit)
{
    Combo combo;
    add(combo, 2, 1);
    EXPECT_FALSE(combo.close());
    EXPECT_EQ(combo.fruit(), 0);
}

TEST(Combo, IsNotMadeOfSeveralSwipes)
{
    Combo combo;
    add(combo, 2, 1);
    add(combo, 2, 2, 2);
    EXPECT_EQ(combo.fruit(), 2);
    EXPECT_FALSE(combo.close());
}

TEST(Combo, EndsWithItsSwipe)
{
    Combo combo;
    add(combo, 4, 7);
    EXPECT_FALSE(combo.tick(7, true, 5));
    const auto closed = combo.tick(7, false, 6);
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->fruit, 4);
    EXPECT_FALSE(combo.tick(7, false, 7)) << "it is paid once";
}

TEST(Combo, EndsWhenAnotherSwipeCuts)
{
    Combo combo;
    add(combo, 3, 1);
    const auto closed = combo.add(2, 3, {});
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->fruit, 3);
    EXPECT_EQ(combo.fruit(), 1);
}

TEST(Combo, EndsWhenTheSwipeFindsNothingMore)
{
    Combo combo;
    add(combo, 3, 1);
    EXPECT_FALSE(combo.tick(1, true, 2 + kComboGap));
    EXPECT_TRUE(combo.tick(1, true, 3 + kComboGap));
}

TEST(Combo, BeginsAgainWithinAnEndlessSwipe)
{
    Combo combo;
    add(combo, 3, 1);
    const auto closed = combo.add(1, 3 + kComboGap, {});
    ASSERT_TRUE(closed);
    EXPECT_EQ(closed->fruit, 3);
    EXPECT_EQ(combo.fruit(), 1);
}

RC_GTEST_PROP(Combo, PaysEveryFruitAtMostOnce, ())
{
    const auto steps =
        *rc::gen::resize(60, rc::gen::container<std::vector<std::pair<std::uint32_t, int>>>(
                                 rc::gen::pair(rc::gen::inRange<std::uint32_t>(0, 2), rc::gen::inRange(0, 50))));
    Combo combo;
    std::uint32_t swipe = 1;
    sim::Tick now = 0;
    int added = 0, paid = 0;
    const auto count = [&](const std::optional<Combo::Closed>& closed) {
        if (!closed) return;
        RC_ASSERT(closed->fruit >= kSmallestCombo);
        paid += closed->fruit;
    };
    for (const auto& [next, wait] : steps) {
        swipe += next;
        now += wait;
        count(combo.tick(swipe, true, now));
        count(combo.add(swipe, now, {}));
        ++added;
    }
    count(combo.close());
    RC_ASSERT(paid <= added);
}

}  // namespace kerf::game
