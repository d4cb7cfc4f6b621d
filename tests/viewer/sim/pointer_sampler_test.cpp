#include "viewer/sim/pointer_sampler.h"

#include <gtest/gtest.h>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace kerf::sim {
namespace {

using Kind = PointerChange::Kind;

// A steady drag from x = 0 to x = 6 in 0.5 s as a window at so many frames per second delivers it: where the pointer is
// at the end of each frame.
std::vector<InputEvent> drag_at(int frames_per_second)
{
    PointerSampler sampler;
    std::vector<InputEvent> events;
    const Microseconds frame = 1'000'000 / frames_per_second;
    const auto deliver = [&](Microseconds end, const PointerChange& change) {
        const auto some = sampler.frame(end - frame, end, std::span(&change, 1));
        events.insert(events.end(), some.begin(), some.end());
    };
    deliver(0, {Kind::press, {0, 0}});
    for (Microseconds t = frame; t < 500'000; t += frame) deliver(t, {Kind::move, {6.0 * double(t) / 500'000.0, 0}});
    deliver(500'000, {Kind::release, {6, 0}});
    return events;
}

TEST(PointerSampler, ASteadyDragIsTheSameAtAnyFrameRate)
{
    for (const int rate : {10, 20, 40}) {
        for (const InputEvent& event : drag_at(rate)) {
            if (event.time <= 0) continue;
            EXPECT_NEAR(event.position.x, 6.0 * double(event.time) / 500'000.0, 2e-4) << rate;
        }
    }
}

TEST(PointerSampler, ALongFrameGivesASampleForEveryTick)
{
    std::vector<int> samples(70, 0);
    for (const InputEvent& event : drag_at(10))
        if (event.time > 0) ++samples[std::size_t(tick_of(event.time))];
    for (std::size_t tick = 1; tick <= 60; ++tick) EXPECT_GE(samples[tick], 1) << tick;
}

TEST(PointerSampler, TimesLieInTheFrameAndNeverDecrease)
{
    PointerSampler sampler;
    const std::vector<PointerChange> changes{{Kind::press, {0, 0}},  {Kind::move, {1, 0}},    {Kind::move, {1, 0}},
                                             {Kind::move, {1, 2}},   {Kind::release, {0, 2}}, {Kind::press, {0, 2}},
                                             {Kind::release, {0, 2}}};
    const auto events = sampler.frame(100'000, 200'000, changes);
    Microseconds last = 100'001;
    for (const InputEvent& event : events) {
        EXPECT_GE(event.time, last);
        last = event.time;
    }
    EXPECT_LE(last, 200'000);
    EXPECT_EQ(events.front().kind, InputKind::press);
    EXPECT_EQ(events.back().kind, InputKind::release);
}

TEST(PointerSampler, EveryCornerOfThePathIsASample)
{
    PointerSampler sampler;
    const std::vector<PointerChange> changes{{Kind::press, {0, 0}}, {Kind::move, {1, 0}}, {Kind::move, {1, 3}}};
    int seen = 0;
    for (const InputEvent& event : sampler.frame(0, 100'000, changes))
        for (const PointerChange& change : changes)
            if (event.position == change.position) ++seen;
    EXPECT_EQ(seen, 3);
}

TEST(PointerSampler, FramesWithoutTimeKeepTheirChangesForTheNext)
{
    PointerSampler sampler;
    const PointerChange press{Kind::press, {1, 1}}, release{Kind::release, {2, 1}};
    EXPECT_TRUE(sampler.frame(50'000, 50'000, std::span(&press, 1)).empty());
    const auto events = sampler.frame(50'000, 60'000, std::span(&release, 1));
    ASSERT_GE(events.size(), 2u);
    EXPECT_EQ(events.front().kind, InputKind::press);
    EXPECT_EQ(events.back().kind, InputKind::release);
}

TEST(PointerSampler, LettingGoEndsASwipeWhereItWas)
{
    PointerSampler sampler;
    const std::vector<PointerChange> swipe{{Kind::press, {0, 0}}, {Kind::move, {1, 0}}};
    sampler.frame(0, 100'000, swipe);
    const PointerChange far_away{Kind::move, {5, 3}};
    sampler.frame(100'000, 100'000, std::span(&far_away, 1));
    sampler.let_go();
    const auto events = sampler.frame(100'000, 200'000, {});
    ASSERT_FALSE(events.empty());
    EXPECT_EQ(events.back().kind, InputKind::release);
    for (const InputEvent& event : events) EXPECT_EQ(event.position, glm::dvec2(1, 0));
    sampler.let_go();
    EXPECT_TRUE(sampler.frame(200'000, 300'000, {}).empty()) << "nothing is held any more";
}

TEST(PointerSampler, MovementWithoutAPressIsNotRecorded)
{
    PointerSampler sampler;
    const PointerChange move{Kind::move, {1, 1}}, release{Kind::release, {2, 1}};
    EXPECT_TRUE(sampler.frame(0, 100'000, std::span(&move, 1)).empty());
    EXPECT_TRUE(sampler.frame(100'000, 200'000, std::span(&release, 1)).empty());
}

}  // namespace
}  // namespace kerf::sim
