#include "viewer/sim/frame_clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace kerf::sim {
namespace {

Tick run(FrameClock& clock, double seconds, int frames)
{
    Tick ticks = 0;
    for (int i = 0; i < frames; ++i) ticks += clock.advance(seconds);
    return ticks;
}

TEST(FrameClock, CountsTheSameTicksAtAnyFrameRate)
{
    for (const int rate : {10, 30, 59, 60, 120, 144, 1000}) {
        FrameClock clock;
        EXPECT_NEAR(double(run(clock, 1.0 / rate, 10 * rate)), 10.0 * kTicksPerSecond, 1.0) << rate;
    }
}

TEST(FrameClock, TellsHowFarThePresentIsPastTheLastTick)
{
    FrameClock clock;
    EXPECT_EQ(clock.advance(1.25 * kTickSeconds), 1);
    EXPECT_NEAR(clock.fraction(), 0.25, 1e-9);
    EXPECT_EQ(clock.advance(0.5 * kTickSeconds), 0);
    EXPECT_NEAR(clock.fraction(), 0.75, 1e-9);
}

TEST(FrameClock, AHitchIsNotCaughtUpWith)
{
    FrameClock clock;
    EXPECT_EQ(clock.advance(60.0), FrameClock::kMostTicks);
    EXPECT_LE(clock.advance(kTickSeconds), 2);
    EXPECT_EQ(FrameClock().advance(std::nan("")), 0);
    EXPECT_EQ(FrameClock().advance(-5.0), 0);
}

TEST(FrameClock, PausedItStepsOnceForEachRequest)
{
    FrameClock clock;
    clock.set_paused(true);
    EXPECT_EQ(run(clock, 0.1, 10), 0);
    clock.step_once();
    EXPECT_EQ(run(clock, 0.1, 10), kTicksPerFrame);
    clock.set_paused(false);
    EXPECT_EQ(clock.advance(0.1), 12);
}

TEST(FrameClock, SlowMotionScalesTimeBeforeTheStep)
{
    FrameClock clock;
    clock.set_slow_motion(true);
    EXPECT_NEAR(double(run(clock, 1.0 / 60, 600)), 10 * kTicksPerSecond * FrameClock::kSlowMotion, 1.0);
}

TEST(FrameClock, AScenesTimeScaleComesBeforeTheStepToo)
{
    FrameClock clock;
    clock.set_time_scale(0.5);
    EXPECT_NEAR(double(run(clock, 0.1, 100)), 600.0, 1.0);
    clock.set_slow_motion(true);
    EXPECT_NEAR(double(run(clock, 0.1, 100)), 600.0 * FrameClock::kSlowMotion, 1.0);
    clock.set_slow_motion(false);
    clock.set_time_scale(1.0);
    EXPECT_NEAR(double(run(clock, 0.1, 100)), 1200.0, 1.0);
}

TEST(Ticks, InputBelongsToTheFirstTickThatIsNotEarlier)
{
    for (Tick n = 0; n < 1'000'000; n += 997) {
        EXPECT_EQ(tick_of(time_of(n)), n);
        EXPECT_EQ(tick_of(time_of(n) + 1), n + 1);
    }
}

}  // namespace
}  // namespace kerf::sim
