#include "viewer/ui/keyboard_blade.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "viewer/sim/blade.h"

namespace kerf::test {

using ui::BladeKey;
using ui::KeyboardBlade;
using Kind = sim::PointerChange::Kind;

namespace {

constexpr double kFrame = 1.0 / 60.0;
const glm::dvec2 kReach(7.0, 4.0);

}  // namespace

TEST(KeyboardBlade, IsNotThereBeforeAKeyIsPressed)
{
    KeyboardBlade blade;
    EXPECT_TRUE(blade.advance(kFrame, kReach).empty());
    EXPECT_FALSE(blade.is_shown());
}

TEST(KeyboardBlade, MovesWithoutCuttingUntilTheKeyForThatIsHeld)
{
    KeyboardBlade blade;
    blade.hold(BladeKey::right, true);
    for (int i = 0; i < 10; ++i) EXPECT_TRUE(blade.advance(kFrame, kReach).empty());
    EXPECT_TRUE(blade.is_shown());
    EXPECT_GT(blade.place().x, 0.5);
    EXPECT_EQ(blade.place().y, 0.0);

    const glm::dvec2 start = blade.place();
    blade.hold(BladeKey::cut, true);
    const auto first = blade.advance(kFrame, kReach);
    ASSERT_EQ(first.size(), 2u);
    EXPECT_EQ(first[0].kind, Kind::press);
    EXPECT_EQ(first[0].position, start);
    EXPECT_EQ(first[1].kind, Kind::move);
    blade.hold(BladeKey::cut, false);
    const auto last = blade.advance(kFrame, kReach);
    ASSERT_EQ(last.size(), 2u);
    EXPECT_EQ(last[1].kind, Kind::release);
    EXPECT_EQ(last[1].position, blade.place());
    EXPECT_TRUE(blade.advance(kFrame, kReach).empty());
}

TEST(KeyboardBlade, IsAlwaysFastEnoughToCutAndAsFastAcrossAsAlong)
{
    for (const bool across : {false, true}) {
        KeyboardBlade blade;
        blade.hold(BladeKey::up, true);
        blade.hold(BladeKey::left, across);
        glm::dvec2 before = blade.place();
        double speed = 0.0;
        for (int i = 0; i < 24; ++i) {
            blade.advance(kFrame, {100.0, 100.0});
            speed = glm::distance(before, blade.place()) / kFrame;
            EXPECT_GT(speed, sim::kSlowestCut);
            before = blade.place();
        }
        EXPECT_NEAR(speed, KeyboardBlade::kFullSpeed, 1e-9);
    }
}

TEST(KeyboardBlade, StaysWhereItCanBeSeen)
{
    KeyboardBlade blade;
    blade.hold(BladeKey::down, true);
    blade.hold(BladeKey::right, true);
    for (int i = 0; i < 200; ++i) blade.advance(kFrame, kReach);
    EXPECT_EQ(blade.place(), glm::dvec2(7.0, -4.0));
    blade.advance(kFrame, {3.0, 2.0});
    EXPECT_EQ(blade.place(), glm::dvec2(3.0, -2.0)) << "the window has become smaller";
}

TEST(KeyboardBlade, ForgetsItsKeysWhenTheGameIsHeld)
{
    KeyboardBlade blade;
    blade.hold(BladeKey::right, true);
    blade.hold(BladeKey::cut, true);
    blade.advance(kFrame, kReach);
    EXPECT_TRUE(blade.is_cutting());
    blade.let_go();
    const glm::dvec2 place = blade.place();
    EXPECT_TRUE(blade.advance(kFrame, kReach).empty());
    EXPECT_EQ(blade.place(), place);
    EXPECT_TRUE(blade.is_shown());
    blade.put_away();
    EXPECT_FALSE(blade.is_shown());
}

}  // namespace kerf::test
