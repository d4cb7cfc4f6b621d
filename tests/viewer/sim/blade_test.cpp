#include "viewer/sim/blade.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "common/support/random.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

std::vector<BladeSegment> segments_of(const std::vector<InputEvent>& events, Gesture gesture = Gesture::blade)
{
    Blade blade;
    blade.set_gesture(gesture);
    std::vector<BladeSegment> segments;
    for (const InputEvent& event : events) {
        std::optional<BladeSegment> segment;
        if (event.kind == InputKind::press) blade.press(event.time, event.position);
        if (event.kind == InputKind::move) segment = blade.move(event.time, event.position);
        if (event.kind == InputKind::release) segment = blade.release(event.time, event.position);
        if (segment) segments.push_back(*segment);
    }
    return segments;
}

TEST(Blade, SegmentsCoverTheSwipeFromEndToEnd)
{
    const auto segments = segments_of(test::stroke(0, 100'000, {-3, 0}, {3, 1}));
    ASSERT_FALSE(segments.empty());
    EXPECT_EQ(segments.front().from, glm::dvec2(-3, 0));
    EXPECT_EQ(segments.back().to, glm::dvec2(3, 1));
    for (std::size_t i = 1; i < segments.size(); ++i) EXPECT_EQ(segments[i].from, segments[i - 1].to);
}

TEST(Blade, SpeedIsPathLengthOverTime)
{
    const auto segments = segments_of(test::stroke(500'000, 100'000, {-3, 0}, {3, 0}));
    for (const BladeSegment& segment : segments) EXPECT_NEAR(segment.speed, 60.0, 60.0 * 0.55);
    EXPECT_NEAR(segments.back().speed, 60.0, 0.1);
}

TEST(Blade, AZigZagIsAsFastAsItsPathIsLong)
{
    Blade blade;
    blade.press(0, {0, 0});
    for (int i = 1; i <= 20; ++i) blade.move(Microseconds{5000} * i, {0.0, i % 2 == 1 ? 0.1 : 0.0});
    EXPECT_NEAR(blade.speed(100'000), 20.0, 1e-9);
}

/// Path length within kSpeedWindow before the last event, over that time, from the events alone.
double speed_by_hand(const std::vector<InputEvent>& events)
{
    const Microseconds end = events.back().time, start = end - kSpeedWindow;
    double length = 0.0;
    for (std::size_t i = 1; i < events.size(); ++i) {
        const InputEvent &a = events[i - 1], &b = events[i];
        if (b.time <= start) continue;
        const double step = glm::distance(a.position, b.position);
        length += a.time >= start ? step : step * double(b.time - start) / double(b.time - a.time);
    }
    return length / (1e-6 * double(std::clamp(end - events.front().time, time_of(1), kSpeedWindow)));
}

TEST(Blade, SpeedIsThatOfTheLastMomentsHoweverLongTheSwipe)
{
    core::Random random(5);
    for (int swipe = 0; swipe < 50; ++swipe) {
        Blade blade;
        std::vector<InputEvent> events;
        Microseconds time = 1'000'000;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec2 place{0.001 * random.below(5000), 0.001 * random.below(3000)};
            events.push_back({time, i == 0 ? InputKind::press : InputKind::move, place, {}});
            i == 0 ? blade.press(time, place) : static_cast<void>(blade.move(time, place));
            EXPECT_NEAR(blade.speed(time), speed_by_hand(events), 1e-9 * speed_by_hand(events));
            time += random.below(8) == 0 ? random.below(100'000) : random.below(3000);
        }
    }
}

TEST(Blade, AMillionMovesInAMomentCostNoMoreEachThanOne)
{
    Blade blade;
    blade.press(0, {0, 0});
    for (int i = 1; i <= 1'000'000; ++i) blade.move(i / 4, {1e-4 * i, 0});
    EXPECT_NEAR(blade.speed(250'000), 20.0 / 0.05, 1.0);
}

TEST(Blade, SlowMovementDoesNotCut)
{
    EXPECT_TRUE(segments_of(test::stroke(0, 1'000'000, {0, 0}, {0.8 * kSlowestCut, 0})).empty());
    EXPECT_FALSE(segments_of(test::stroke(0, 1'000'000, {0, 0}, {1.5 * kSlowestCut, 0})).empty());
}

TEST(Blade, MovementWithoutAPressDoesNotCut)
{
    Blade blade;
    EXPECT_FALSE(blade.move(0, {0, 0}));
    EXPECT_FALSE(blade.move(8'000, {3, 0}));
    EXPECT_FALSE(blade.release(9'000, {4, 0}));
    blade.press(10'000, {0, 0});
    blade.release(20'000, {1, 0});
    EXPECT_FALSE(blade.move(30'000, {5, 0}));
}

TEST(Blade, EveryPressIsASwipeOfItsOwn)
{
    Blade blade;
    EXPECT_EQ(blade.swipe(), 0u);
    blade.press(0, {0, 0});
    const auto first = blade.release(10'000, {1, 0});
    blade.press(20'000, {0, 0});
    const auto second = blade.release(30'000, {1, 0});
    EXPECT_EQ(first.value().swipe, 1u);
    EXPECT_EQ(second.value().swipe, 2u);
    EXPECT_EQ(second.value().base, glm::dvec2(0, 0)) << "nothing of an earlier swipe is left";
}

TEST(Blade, TrembleByPixelsDoesNotTurnThePlane)
{
    // A fast stroke to the right, sampled at 1000 Hz and rounded to pixels of 1.1 cm.
    std::vector<InputEvent> events = test::stroke(0, 200'000, {-3, 0.004}, {3, 0.3}, 1000);
    for (InputEvent& event : events) event.position = glm::round(event.position / 0.011) * 0.011;
    for (const BladeSegment& segment : segments_of(events)) {
        if (segment.to.x < -2.4) continue;  // the first part of a stroke has no longer chord
        const glm::dvec2 chord = segment.to - segment.base;
        EXPECT_NEAR(std::atan2(chord.y, chord.x), std::atan2(0.296, 6.0), 3.0 * std::numbers::pi / 180.0);
    }
}

TEST(Blade, AClickDoesNotCut)
{
    EXPECT_TRUE(segments_of(test::stroke(0, 8'000, {1, 1}, {1, 1})).empty());
    EXPECT_TRUE(segments_of(test::stroke(0, 8'000, {1, 1}, {1, 1}), Gesture::segment).empty());
}

TEST(Blade, TheSegmentGestureCutsOnceFromPressToRelease)
{
    std::vector<InputEvent> events = test::stroke(0, 2'000'000, {-1, 0}, {1, 2});
    events[3].position = {7, 7};  // what the pointer did between does not matter
    const auto segments = segments_of(events, Gesture::segment);
    ASSERT_EQ(segments.size(), 1u);
    EXPECT_EQ(segments[0].from, glm::dvec2(-1, 0));
    EXPECT_EQ(segments[0].base, glm::dvec2(-1, 0));
    EXPECT_EQ(segments[0].to, glm::dvec2(1, 2));
}

TEST(Blade, TheTrailIsTheLastMomentsOfThePath)
{
    Blade blade;
    blade.press(0, {0, 0});
    for (int i = 1; i <= 100; ++i) blade.move(Microseconds{10'000} * i, {0.1 * i, 0});
    const auto trail = blade.trail(1'000'000);
    ASSERT_EQ(trail.size(), std::size_t(kTrail / 10'000) + 1);
    EXPECT_EQ(trail.back().position, glm::dvec2(10, 0));
    EXPECT_TRUE(blade.trail(2'000'000).empty());
}

TEST(Blade, ForgetsAnEndlessSwipe)
{
    Blade blade;
    blade.press(0, {0, 0});
    for (int i = 1; i <= 200'000; ++i) blade.move(Microseconds{1000} * i, {std::sin(i * 0.1), std::cos(i * 0.1)});
    EXPECT_LE(blade.remembered(), 600u);
}

}  // namespace
}  // namespace kerf::sim
