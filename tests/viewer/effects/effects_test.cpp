#include "viewer/effects/effects.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "viewer/game/autopilot.h"
#include "viewer/game/fruit_models.h"
#include "viewer/game/scenes.h"
#include "viewer/sim/camera.h"

namespace kerf::test {

namespace {

std::shared_ptr<sim::ModelLibrary> fruit()
{
    static const auto library = [] {
        auto made = std::make_shared<sim::ModelLibrary>();
        game::add_fruit_models(*made, KERF_DATA_DIR "/fruit");
        return made;
    }();
    return library;
}

/// A game that the program plays by itself, and what is seen of it.
struct Played
{
    explicit Played(game::GameMode mode, std::uint64_t seed = 3)
        : simulation(fruit(), with_seed(seed), std::make_unique<game::GameScene>(mode, *fruit())), autopilot(seed)
    {
    }
    static sim::Settings with_seed(std::uint64_t seed)
    {
        sim::Settings settings;
        settings.seed = seed;
        return settings;
    }
    void frame(bool is_watched)
    {
        simulation.push(autopilot.play(simulation));
        simulation.advance(2);
        if (is_watched) effects.follow(simulation);
    }

    sim::Simulation simulation;
    game::Autopilot autopilot;
    effects::Effects effects;
};

}  // namespace

TEST(Effects, DoNotChangeWhatHappens)
{
    Played watched(game::GameMode::arcade), alone(game::GameMode::arcade);
    for (int i = 0; i < 400; ++i) {
        watched.frame(true);
        alone.frame(false);
    }
    EXPECT_GT(watched.simulation.cuts().size(), 3u);
    EXPECT_EQ(watched.simulation.state_hash(), alone.simulation.state_hash());
}

TEST(Effects, AreTheSameForTheSameRun)
{
    Played first(game::GameMode::zen), second(game::GameMode::zen);
    for (int i = 0; i < 400; ++i) {
        first.frame(true);
        second.frame(true);
        ASSERT_EQ(first.effects.drops().all().size(), second.effects.drops().all().size());
        ASSERT_EQ(first.effects.stains().all().size(), second.effects.stains().all().size());
        for (std::size_t d = 0; d < first.effects.drops().all().size(); ++d)
            ASSERT_EQ(first.effects.drops().all()[d].place, second.effects.drops().all()[d].place);
    }
}

TEST(Effects, JuiceFliesAndStainsTheWallWhenAFruitIsCut)
{
    Played played(game::GameMode::zen);
    for (int i = 0; i < 600 && played.simulation.cuts().empty(); ++i) {
        EXPECT_TRUE(played.effects.drops().all().empty());
        played.frame(true);
    }
    ASSERT_FALSE(played.simulation.cuts().empty());
    const std::string& model = fruit()->model(played.simulation.cuts()[0].model).name;
    EXPECT_GT(played.effects.drops().all().size(), 10u) << model;
    EXPECT_EQ(played.effects.stains().all().size(), 1u);
    EXPECT_FALSE(played.effects.popups().all().empty());
    const auto known = [&](const game::Fruit& f) {
        return f.model == model && f.juice == played.effects.stains().all()[0].colour;
    };
    const auto all = game::fruit_catalogue();
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), known)) << "the stain has the colour of the fruit's juice";
}

TEST(Effects, NameASpecialFruitWhoseEffectBegins)
{
    using enum game::FruitKind;
    const std::map<game::FruitKind, std::string> names{
        {freeze, "Freeze"}, {frenzy, "Frenzy"}, {double_points, "Double points"}, {hammer, "Hammer"}};
    std::set<game::FruitKind> begun;
    for (std::uint64_t seed = 1; seed < 10 && begun.size() < names.size(); ++seed) {
        Played played(game::GameMode::arcade, seed);
        std::size_t seen = 0;
        for (int i = 0; i < 1200; ++i) {
            played.frame(true);
            const auto events = game::game_of(played.simulation.scene())->events();
            for (; seen < events.size(); ++seen) {
                if (events[seen].kind != game::GameEventKind::special_started) continue;
                const game::FruitKind kind = events[seen].fruit.value();
                const auto is_name = [&](const effects::Popup& popup) { return popup.text == names.at(kind); };
                EXPECT_TRUE(std::ranges::any_of(played.effects.popups().all(), is_name)) << names.at(kind);
                begun.insert(kind);
            }
        }
    }
    EXPECT_EQ(begun.size(), names.size());
}

TEST(Effects, StayBoundedHoweverLongAGameLasts)
{
    Played played(game::GameMode::arcade, 5);
    float flash = 0.0f;
    for (int i = 0; i < 2400; ++i) {
        played.frame(true);
        ASSERT_LE(played.effects.drops().all().size(), effects::Drops::kMost);
        ASSERT_LE(played.effects.stains().all().size(), effects::Stains::kMost);
        ASSERT_LE(played.effects.popups().all().size(), effects::Popups::kMost);
        ASSERT_GE(played.effects.time_scale(), 0.1);
        ASSERT_LE(played.effects.time_scale(), 1.0);
        flash = std::max(flash, played.effects.flash());
        ASSERT_LE(played.effects.flash(), 1.0f);
    }
    EXPECT_GT(played.simulation.cuts().size(), 20u);
}

namespace {

/// A model that a click breaks, and what is seen of it.
struct Broken
{
    explicit Broken(const std::shared_ptr<sim::ModelLibrary>& models)
        : simulation(models, {}, game::make_scene("shatter", models))
    {
        simulation.command("strength 0");
        simulation.advance(60);
        effects.follow(simulation);
    }
    void click()
    {
        const glm::dvec2 place = sim::Camera::seen_on_stage(simulation.bodies().front()->centre());
        simulation.push({simulation.time() + 1, sim::InputKind::press, place, {}});
        simulation.advance(2);
        effects.follow(simulation);
    }
    std::size_t count(effects::DropKind kind) const
    {
        return std::size_t(std::ranges::count_if(effects.drops().all(), [&](const auto& d) { return d.kind == kind; }));
    }

    sim::Simulation simulation;
    effects::Effects effects;
};

}  // namespace

TEST(Effects, StoneBreaksInDustAndCrumbs)
{
    auto models = std::make_shared<sim::ModelLibrary>();
    models->add_file(KERF_DATA_DIR "/models/rook.obj");
    Broken broken(models);
    EXPECT_TRUE(broken.effects.drops().all().empty());
    broken.click();
    ASSERT_EQ(broken.simulation.breaks().size(), 1u);
    EXPECT_GT(broken.count(effects::DropKind::mist), 5u);
    EXPECT_GT(broken.count(effects::DropKind::crumb), 10u);
    EXPECT_EQ(broken.count(effects::DropKind::juice), 0u);
    EXPECT_TRUE(broken.effects.stains().all().empty());
    EXPECT_FALSE(broken.effects.shake().at_rest());
}

TEST(Effects, FruitThatBreaksBleeds)
{
    Broken broken(fruit());
    broken.click();
    ASSERT_EQ(broken.simulation.breaks().size(), 1u);
    EXPECT_GT(broken.count(effects::DropKind::juice), 20u);
    EXPECT_EQ(broken.count(effects::DropKind::crumb), 0u);
    EXPECT_FALSE(broken.effects.stains().all().empty());
}

}  // namespace kerf::test
