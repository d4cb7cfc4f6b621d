#include "viewer/game/shatter_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <set>

#include "viewer/game/autopilot.h"
#include "viewer/game/scenes.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/camera.h"
#include "viewer/sim/simulation.h"
#include "viewer/support/stages.h"

namespace kerf::game {
namespace {

sim::Simulation play(const std::string& backend = sim::backend_names().front(), std::uint64_t seed = 3)
{
    const auto models = test::library_of({"asteroid", "torus"}, 1500);
    sim::Settings settings;
    settings.backend = backend;
    settings.seed = seed;
    return sim::Simulation(models, settings, make_scene("shatter", models));
}

ShatterSettings settings_of(const sim::Simulation& simulation)
{
    return shatter_of(simulation.scene())->settings();
}

/// Lets the first object fly to where it can be hit.
void fly_up(sim::Simulation& simulation)
{
    simulation.advance(60);
    ASSERT_EQ(simulation.bodies().size(), 1u);
}

void click(sim::Simulation& simulation, const glm::dvec2& place)
{
    simulation.push({simulation.time() + 1, sim::InputKind::press, place, {}});
    simulation.push({simulation.time() + 2, sim::InputKind::release, place, {}});
    simulation.advance(2);
}

void click_first(sim::Simulation& simulation)
{
    click(simulation, sim::Camera::seen_on_stage(simulation.bodies().front()->centre()));
}

std::size_t held(const sim::Simulation& simulation)
{
    std::size_t members = 0;
    for (const auto& cluster : simulation.world().clusters()) members += cluster->members().size();
    return members;
}

class ShatterSceneTest : public testing::TestWithParam<std::string>
{
};

INSTANTIATE_TEST_SUITE_P(BackEnds, ShatterSceneTest, testing::ValuesIn(sim::backend_names()), test::back_end_test_name);

}  // namespace

TEST_P(ShatterSceneTest, AClickBreaksWhatItHits)
{
    sim::Simulation simulation = play(GetParam());
    simulation.command("cells 30");
    fly_up(simulation);
    click_first(simulation);
    ASSERT_EQ(simulation.breaks().size(), 1u);
    EXPECT_EQ(simulation.breaks().front().status, Status::done);
    EXPECT_EQ(simulation.breaks().front().backend, GetParam());
    EXPECT_GE(simulation.bodies().size(), 30u);
    EXPECT_TRUE(simulation.cuts().empty()) << "nothing is cut here";
}

TEST_P(ShatterSceneTest, ItCracksBeforeItFallsApart)
{
    sim::Simulation simulation = play(GetParam());
    simulation.command("strength 2000");
    fly_up(simulation);
    click_first(simulation);
    const std::size_t at_first = held(simulation);
    EXPECT_GT(at_first, 0u) << "most of it hangs together";
    for (int i = 0; i < 12 && held(simulation) > 0; ++i) {
        const auto& clusters = simulation.world().clusters();
        const auto largest = std::max_element(clusters.begin(), clusters.end(), [](const auto& a, const auto& b) {
            return a->members().size() < b->members().size();
        });
        click(simulation, sim::Camera::seen_on_stage((*largest)->centre()));
    }
    EXPECT_LT(held(simulation), at_first);
}

TEST(ShatterScene, WithoutStrengthItFallsApartAtOnce)
{
    sim::Simulation simulation = play();
    simulation.command("strength 0");
    fly_up(simulation);
    click_first(simulation);
    EXPECT_EQ(held(simulation), 0u);
    EXPECT_EQ(simulation.cracks().back().parts, simulation.bodies().size());
}

TEST(ShatterScene, AClickBesideItDoesNothing)
{
    sim::Simulation simulation = play();
    fly_up(simulation);
    const glm::dvec2 seen = sim::Camera::seen_on_stage(simulation.bodies().front()->centre());
    click(simulation, {seen.x > 0.0 ? -6.0 : 6.0, seen.y});
    EXPECT_TRUE(simulation.breaks().empty());
    EXPECT_EQ(simulation.bodies().size(), 1u);
}

TEST(ShatterScene, AFreePieceBreaksAgainAndACrumbIsPushed)
{
    sim::Simulation simulation = play();
    simulation.command("strength 0");
    simulation.command("cells 8");
    fly_up(simulation);
    click_first(simulation);
    ASSERT_EQ(simulation.breaks().size(), 1u);
    for (int i = 0; i < 6; ++i) click_first(simulation);
    EXPECT_GT(simulation.breaks().size(), 1u);
    for (std::size_t i = 1; i < simulation.breaks().size(); ++i)
        EXPECT_LE(simulation.breaks()[i].pieces.size(), 8u) << "into few";
}

TEST(ShatterScene, IsSetByCommandsAndSaysWhatItDoesNotTake)
{
    sim::Simulation simulation = play();
    const auto say = [&](const std::string& command) {
        simulation.command(command);
        simulation.advance();
        return simulation.take_message();
    };
    EXPECT_EQ(say("cells 77"), "");
    EXPECT_EQ(settings_of(simulation).cells, 77u);
    EXPECT_EQ(say("pattern splinters"), "");
    EXPECT_EQ(settings_of(simulation).pattern, FracturePattern::splinters);
    EXPECT_EQ(say("strength 12.5"), "");
    EXPECT_EQ(settings_of(simulation).strength, 12.5);
    for (const char* const wrong : {"cells 1", "cells 301", "cells many", "cells", "strength -1", "strength nan",
                                    "strength 1e9", "pattern bricks", "throw teapot", "dance"})
        EXPECT_NE(say(wrong), "") << wrong;
    EXPECT_EQ(settings_of(simulation).cells, 77u);
    EXPECT_EQ(settings_of(simulation).pattern, FracturePattern::splinters);
    EXPECT_EQ(settings_of(simulation).strength, 12.5);
}

TEST(ShatterScene, EveryPatternBreaksEveryModel)
{
    for (const std::string_view pattern : kPatternNames) {
        sim::Simulation simulation = play();
        simulation.command("pattern " + std::string(pattern));
        fly_up(simulation);
        click_first(simulation);
        ASSERT_EQ(simulation.breaks().size(), 1u) << pattern;
        EXPECT_EQ(simulation.breaks().front().status, Status::done) << pattern;
        EXPECT_GE(simulation.breaks().front().pieces.size(), 10u) << pattern;
    }
}

TEST_P(ShatterSceneTest, TheSameClicksGiveTheSameState)
{
    const auto hash = [&] {
        sim::Simulation simulation = play(GetParam(), 9);
        Autopilot autopilot(2);
        for (int i = 0; i < 300; ++i) {
            simulation.push(autopilot.play(simulation));
            simulation.advance(2);
        }
        EXPECT_GT(simulation.breaks().size(), 1u);
        return simulation.state_hash();
    };
    EXPECT_EQ(hash(), hash());
}

TEST(ShatterScene, AnotherModelComesWhenTheLastIsBroken)
{
    sim::Simulation simulation = play();
    simulation.command("strength 0");
    fly_up(simulation);
    click_first(simulation);
    std::set<std::size_t> models;
    for (int i = 0; i < 1200; ++i) {
        simulation.advance();
        for (const auto& body : simulation.bodies()) models.insert(body->identity().origin.model);
    }
    EXPECT_EQ(models.size(), 2u);
}

}  // namespace kerf::game
