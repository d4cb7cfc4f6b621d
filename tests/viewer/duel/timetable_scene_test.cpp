#include "viewer/duel/timetable_scene.h"

#include <gtest/gtest.h>

#include "viewer/support/stages.h"

namespace kerf::test {

using duel::TimetableScene;

namespace {

sim::Simulation stage(std::uint64_t seed)
{
    sim::Settings settings;
    settings.seed = seed;
    return {library_of({"icosphere", "box"}), settings,
            std::make_unique<TimetableScene>(std::vector<TimetableScene::Item>{{0}, {1, 2.0}})};
}

}  // namespace

TEST(TimetableScene, ThrowsByTheClockAndInTurn)
{
    sim::Simulation simulation = stage(1);
    simulation.advance(TimetableScene::kGetReady - 1);
    EXPECT_FALSE(simulation.last_throw());
    simulation.advance();
    ASSERT_TRUE(simulation.last_throw());
    EXPECT_EQ(simulation.last_throw()->model, 0u);
    simulation.advance(TimetableScene::kInterval);
    EXPECT_EQ(simulation.last_throw()->model, 1u);
    simulation.advance(TimetableScene::kInterval);
    EXPECT_EQ(simulation.last_throw()->model, 0u);
}

TEST(TimetableScene, ThrowsEachAsLargeAsItIsToBe)
{
    sim::Simulation simulation = stage(1);
    const auto thrown_radius = [&] {
        const sim::Origin& origin = simulation.bodies().back()->identity().origin;
        return origin.radius * origin.scale;
    };
    simulation.advance(TimetableScene::kGetReady);
    EXPECT_NEAR(thrown_radius(), sim::kThrownRadius, 1e-6);
    simulation.advance(TimetableScene::kInterval);
    EXPECT_NEAR(thrown_radius(), 2.0, 1e-6);
}

TEST(TimetableScene, ThrowsNothingAnyMoreWhenTheDuelIsAboutToEnd)
{
    sim::Simulation simulation = stage(1);
    simulation.advance(TimetableScene::kLastThrow);
    const std::optional<sim::Throw> last = simulation.last_throw();
    EXPECT_FALSE(simulation.bodies().empty());
    simulation.advance(TimetableScene::kLength);
    EXPECT_EQ(simulation.last_throw(), last);
    EXPECT_TRUE(simulation.bodies().empty());
}

TEST(TimetableScene, DoesNotMindWhatBecameOfItsThrows)
{
    // One of them is cut to pieces, the other is left alone.
    sim::Simulation calm = stage(3), busy = stage(3);
    for (int i = 0; i < 8; ++i)
        busy.push(stroke(1'000'000 + 300'000 * i, 90'000, {-6.0, -2.0 + 0.4 * i}, {6.0, 2.0 - 0.4 * i}));
    for (int i = 0; i < 900; ++i) {
        calm.advance();
        busy.advance();
        ASSERT_EQ(calm.last_throw(), busy.last_throw()) << "tick " << i;
    }
    EXPECT_GT(busy.cuts().size(), 0u);
    EXPECT_EQ(calm.cuts().size(), 0u);
}

}  // namespace kerf::test
