#include "viewer/game/game_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <stdexcept>

#include "viewer/game/autopilot.h"
#include "viewer/game/games.h"
#include "viewer/game/scenes.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/camera.h"

namespace kerf::game {
namespace {

using test::Game;
using Kind = GameEventKind;

void play_with_autopilot(Game& game, sim::Tick ticks)
{
    Autopilot autopilot(1);
    for (sim::Tick i = 0; i < ticks; i += 2) {
        game.simulation().push(autopilot.play(game.simulation()));
        game.simulation().advance(2);
    }
}

// Waits for a fruit and cuts it.
void cut_one(Game& game, double beside = 0.0)
{
    ASSERT_TRUE(game.play_until([&] { return game.find_fruit() != nullptr; }));
    game.swipe_through(*game.find_fruit(), beside);
}

}  // namespace

TEST(GameScene, ThrowsItsFirstWaveAfterASecond)
{
    Game game(GameMode::classic);
    game.simulation().advance(kGetReady - 1);
    EXPECT_TRUE(game.simulation().bodies().empty());
    game.simulation().advance();
    ASSERT_EQ(game.simulation().bodies().size(), 1u);
    ASSERT_EQ(game.scene().events().size(), 2u);
    EXPECT_EQ(game.scene().events()[0].kind, Kind::wave);
    EXPECT_EQ(game.scene().events()[1].kind, Kind::thrown);
    EXPECT_EQ(game.scene().events()[1].object, game.simulation().bodies()[0]->id());
}

TEST(GameScene, ThrowsItsFruitInTheirSizes)
{
    Game game(GameMode::zen);
    ASSERT_TRUE(game.play_until([&] { return game.find_fruit() != nullptr; }));
    const sim::Body& body = *game.find_fruit();
    const Fruit& fruit = fruit_of(*game.scene().whole(body.id()));
    EXPECT_NEAR(body.identity().origin.scale * body.identity().origin.radius, fruit.radius, 1e-9);
}

TEST(GameScene, FallsTwiceAsFastAsNature)
{
    EXPECT_DOUBLE_EQ(Game(GameMode::zen).simulation().world().gravity(), 2.0 * 9.81);
}

TEST(GameScene, PaysForAFruitThatIsCut)
{
    Game game(GameMode::classic);
    cut_one(game, 0.35);
    ASSERT_EQ(game.events(Kind::fruit_cut).size(), 1u);
    const GameEvent event = game.events(Kind::fruit_cut)[0];
    EXPECT_EQ(game.state().score, fruit_of(*event.fruit).points);
    EXPECT_EQ(game.simulation().cuts().size(), 1u);
    EXPECT_EQ(event.cut, game.simulation().cuts()[0].number);
    EXPECT_EQ(event.object, game.simulation().cuts()[0].object);
    EXPECT_EQ(event.tick, game.simulation().cuts()[0].tick);
}

TEST(GameScene, CallsACutThroughTheMiddleCritical)
{
    Game game(GameMode::classic);
    cut_one(game, 0.0);
    EXPECT_EQ(game.state().counts.criticals, 1);
    EXPECT_EQ(game.events(Kind::critical).size(), 1u);
}

TEST(GameScene, PaysNothingForPieces)
{
    Game game(GameMode::classic);
    cut_one(game);
    const std::int64_t score = game.state().score;
    const std::size_t events = game.scene().events().size();
    ASSERT_GE(game.simulation().bodies().size(), 2u);
    for (int i = 0; i < 3; ++i) game.swipe_through(*game.simulation().bodies().back());
    EXPECT_GE(game.simulation().cuts().size(), 3u) << "they are cut all the same";
    EXPECT_EQ(game.state().score, score);
    EXPECT_EQ(game.scene().events().size(), events);
}

TEST(GameScene, TakesALifeForAFruitThatFallsDownWhole)
{
    Game game(GameMode::classic);
    ASSERT_TRUE(game.play_until([&] { return !game.events(Kind::missed).empty(); }));
    EXPECT_EQ(game.state().lives, 2);
    const GameEvent missed = game.events(Kind::missed)[0];
    EXPECT_LE(std::abs(missed.place.x), sim::kStageHalfWidth);
    EXPECT_NEAR(missed.place.y, -sim::kStageHalfHeight, 1e-9) << "where it left";
}

TEST(GameScene, MissesNoFruitThatWasNeverWhollyOnTheStage)
{
    std::size_t missed = 0;
    for (const std::uint64_t seed : {1u, 2u, 3u, 4u}) {
        Game game(GameMode::zen, seed);
        Autopilot autopilot(seed);
        std::set<sim::ObjectId> seen;
        for (sim::Tick i = 0; i < 20 * sim::kTicksPerSecond; ++i) {
            game.simulation().push(autopilot.play(game.simulation()));
            game.simulation().advance();
            for (const auto& body : game.simulation().bodies()) {
                const glm::dvec3 place = body->centre();
                if (std::abs(place.x) + body->radius() <= sim::kStageHalfWidth &&
                    std::abs(place.y) + body->radius() <= sim::kStageHalfHeight)
                    seen.insert(body->id());
            }
        }
        for (const GameEvent& event : game.events(Kind::missed)) {
            EXPECT_TRUE(seen.contains(event.object)) << "seed " << seed << ", tick " << event.tick;
            ++missed;
        }
    }
    EXPECT_GT(missed, 0u);
}

TEST(GameScene, TakesNoLifeForPieces)
{
    Game game(GameMode::classic);
    cut_one(game);
    const sim::ObjectId last_piece = game.simulation().bodies().back()->id();
    const auto pieces_are_gone = [&] {
        const auto bodies = game.simulation().bodies();
        return bodies.empty() || bodies.front()->id() > last_piece;
    };
    ASSERT_TRUE(game.play_until(pieces_are_gone));
    EXPECT_EQ(game.state().lives, 3);
    EXPECT_TRUE(game.events(Kind::missed).empty());
}

TEST(GameScene, EndsAfterThreeFruitThatNobodyCut)
{
    Game game(GameMode::classic);
    ASSERT_TRUE(game.play_until([&] { return game.is_over(); }));
    EXPECT_EQ(game.state().end, GameEnd::missed);
    EXPECT_EQ(game.state().score, 0);
    const std::size_t thrown = game.events(Kind::thrown).size();
    game.simulation().advance(5 * sim::kTicksPerSecond);
    EXPECT_EQ(game.events(Kind::thrown).size(), thrown);
    EXPECT_TRUE(game.simulation().bodies().empty()) << "nothing is thrown any more";
}

TEST(GameScene, EndsWithABomb)
{
    Game game(GameMode::classic);
    while (!game.is_over() && game.find(FruitKind::bomb) == nullptr) {
        if (const sim::Body* const fruit = game.find_fruit()) {
            game.swipe_through(*fruit);
        } else {
            game.simulation().advance();
        }
    }
    ASSERT_FALSE(game.is_over());
    game.swipe_through(*game.find(FruitKind::bomb));
    EXPECT_EQ(game.state().end, GameEnd::bomb);
}

TEST(GameScene, MakesACombo)
{
    Game game(GameMode::zen, 2);
    const auto three_fly = [&] {
        const auto bodies = game.simulation().bodies();
        return std::count_if(bodies.begin(), bodies.end(), [&](const auto& body) {
                   return game.scene().whole(body->id()) && sim::Camera::seen_on_stage(body->centre()).y > -3.0;
               }) >= 3;
    };
    ASSERT_TRUE(game.play_until(three_fly));
    game.press({7.0, 4.0});
    while (game.find_fruit() != nullptr && game.state().combo < 3) game.sweep_through(*game.find_fruit());
    ASSERT_GE(game.state().combo, 3);
    EXPECT_EQ(game.state().counts.combos, 0) << "not before the swipe ends";
    game.release();
    game.simulation().advance();
    EXPECT_EQ(game.state().counts.combos, 1);
    EXPECT_GE(game.events(Kind::combo)[0].points, 3);
}

TEST(GameScene, SlowsTimeWhileFrozenAndOnlyThen)
{
    Game game(GameMode::arcade, 1);
    const auto cut_until_frozen = [&] {
        if (const sim::Body* const ice = game.find(FruitKind::freeze)) game.swipe_through(*ice);
        return game.scene().time_scale() < 1.0;
    };
    for (std::uint64_t seed = 1; seed < 20 && game.scene().time_scale() == 1.0; ++seed) {
        game = Game(GameMode::arcade, seed);
        game.play_until(cut_until_frozen, 40 * sim::kTicksPerSecond);
    }
    EXPECT_DOUBLE_EQ(game.scene().time_scale(), kFrozenTimeScale);
    EXPECT_EQ(game.events(Kind::special_started).back().fruit, FruitKind::freeze);
    game.simulation().advance(kFreezeTicks);
    EXPECT_DOUBLE_EQ(game.scene().time_scale(), 1.0);
}

TEST(GameScene, ThrowsFromTheSidesInAFrenzy)
{
    bool was_seen = false;
    for (std::uint64_t seed = 1; seed < 20 && !was_seen; ++seed) {
        Game game(GameMode::arcade, seed);
        was_seen = game.play_until(
            [&] {
                if (const sim::Body* const hot = game.find(FruitKind::frenzy)) game.swipe_through(*hot);
                return !game.events(Kind::special_started).empty();
            },
            40 * sim::kTicksPerSecond);
        if (!was_seen) continue;
        const std::size_t before = game.events(Kind::thrown).size();
        game.simulation().advance(kFrenzyTicks - 2);
        const std::vector<GameEvent> thrown = game.events(Kind::thrown);
        constexpr sim::Tick kThrows = kFrenzyTicks / kFrenzyGap;
        EXPECT_NEAR(double(thrown.size() - before), double(kThrows), 1.0);
        for (std::size_t i = before; i < thrown.size(); ++i)
            EXPECT_NEAR(std::abs(thrown[i].place.x), sim::kStageHalfWidth, 1e-9);
    }
    EXPECT_TRUE(was_seen);
}

TEST(GameScene, SaysWhatBursts)
{
    bool saw_frozen = false, saw_hammer = false;
    for (std::uint64_t seed = 1; seed < 40 && !(saw_frozen && saw_hammer); ++seed) {
        Game game(GameMode::arcade, seed);
        const auto hammers = [&] {
            return std::ranges::count(game.events(Kind::special_started), FruitKind::hammer,
                                      [](const GameEvent& event) { return event.fruit; }) > 0;
        };
        game.play_until(
            [&] {
                if (hammers()) return true;
                for (const auto& body : game.simulation().bodies()) {
                    const std::optional<FruitKind> kind = game.scene().whole(body->id());
                    EXPECT_EQ(game.scene().bursts(body->id()), kind == FruitKind::frozen);
                    saw_frozen = saw_frozen || kind == FruitKind::frozen;
                }
                if (const sim::Body* const hammer = game.find(FruitKind::hammer)) game.swipe_through(*hammer);
                return false;
            },
            20 * sim::kTicksPerSecond);
        if (!hammers()) continue;
        saw_hammer = true;
        std::size_t whole = 0, pieces = 0;
        for (sim::Tick i = 0; i < kHammerTicks - 2; ++i) {
            for (const auto& body : game.simulation().bodies()) {
                const std::optional<FruitKind> kind = game.scene().whole(body->id());
                EXPECT_EQ(game.scene().bursts(body->id()), kind && *kind != FruitKind::bomb);
                ++(kind ? whole : pieces);
            }
            game.simulation().advance();
        }
        EXPECT_GT(whole, 0u);
        EXPECT_GT(pieces, 0u) << "the hammer's own";
        game.simulation().advance(4);
        for (const auto& body : game.simulation().bodies())
            EXPECT_EQ(game.scene().bursts(body->id()), game.scene().whole(body->id()) == FruitKind::frozen);
    }
    EXPECT_TRUE(saw_frozen);
    EXPECT_TRUE(saw_hammer);
}

// Plays arcade games until the kind is on the stage, whole, and swipes through it. Null: no game threw one.
std::unique_ptr<Game> swipe_at(FruitKind kind, const std::string& backend)
{
    for (std::uint64_t seed = 1; seed < 40; ++seed) {
        auto game = std::make_unique<Game>(GameMode::arcade, seed, backend);
        const bool is_there = game->play_until([&] { return game->find(kind) != nullptr; }, 40 * sim::kTicksPerSecond);
        if (!is_there) continue;
        game->swipe_through(*game->find(kind));
        return game;
    }
    return nullptr;
}

TEST(GameScene, AFrozenFruitBurstsInsteadOfParting)
{
    for (const std::string& backend : sim::backend_names()) {
        const std::unique_ptr<Game> game = swipe_at(FruitKind::frozen, backend);
        ASSERT_NE(game, nullptr);
        game->simulation().advance(4);
        ASSERT_EQ(game->simulation().breaks().size(), 1u) << backend;
        const sim::BreakRecord& broken = game->simulation().breaks().front();
        EXPECT_EQ(broken.status, Status::done);
        EXPECT_GE(broken.pieces.size(), 15u);
        EXPECT_TRUE(game->simulation().world().clusters().empty()) << "nothing hangs together";
        // The stroke may meet other fruit, too.
        std::int64_t points = 0, times = 0;
        for (const GameEvent& event : game->scene().events()) {
            if (event.object != broken.object || event.kind == Kind::thrown) continue;
            EXPECT_EQ(event.kind, Kind::fruit_cut) << "nothing critical, nothing missed";
            points += event.points;
            ++times;
        }
        EXPECT_EQ(times, 1) << "once";
        EXPECT_EQ(points, fruit_of(FruitKind::frozen).points);
    }
}

TEST(GameScene, UnderTheHammerFruitIsSmashedAndItsPiecesAreCut)
{
    const std::unique_ptr<Game> game = swipe_at(FruitKind::hammer, sim::backend_names().front());
    ASSERT_NE(game, nullptr);
    game->simulation().advance(4);
    ASSERT_TRUE(std::ranges::any_of(game->state().specials, [](const auto& s) { return s.kind == FruitKind::hammer; }));
    EXPECT_EQ(game->simulation().breaks().size(), 0u) << "the one that brings the hammer is cut";
    ASSERT_EQ(game->simulation().cuts().size(), 1u);
    ASSERT_TRUE(game->play_until([&] { return game->find_fruit() != nullptr; }, 3 * sim::kTicksPerSecond));
    const std::int64_t before = game->state().counts.fruit_cut;
    game->swipe_through(*game->find_fruit());
    game->simulation().advance(4);
    ASSERT_GE(game->simulation().breaks().size(), 1u);
    EXPECT_GT(game->state().counts.fruit_cut, before);
    const auto piece = std::ranges::max_element(game->simulation().bodies(), {}, [](const auto& body) {
        return body->identity().parent == 0 ? 0.0 : body->mass();
    });
    EXPECT_FALSE(game->scene().smashes(**piece)) << "pieces are cut as ever";
}

TEST(GameScene, GivesUpOnCommand)
{
    Game game(GameMode::zen);
    game.simulation().command("over");
    game.simulation().advance();
    EXPECT_EQ(game.state().end, GameEnd::given_up);
    game.simulation().command("jump");
    game.simulation().advance();
    EXPECT_NE(game.simulation().take_message(), "");
}

TEST(GameScene, GivesTheSameGameTwice)
{
    for (const std::string& backend : sim::backend_names()) {
        for (const GameMode mode : kGameModes) {
            Game first(mode, 7, backend), second(mode, 7, backend);
            play_with_autopilot(first, 1800);
            second.simulation().push(first.simulation().recording().events);
            second.simulation().advance(1800);
            EXPECT_GT(first.state().score, 0);
            EXPECT_EQ(first.state().score, second.state().score);
            EXPECT_EQ(first.scene().events().size(), second.scene().events().size());
            EXPECT_EQ(first.simulation().state_hash(), second.simulation().state_hash()) << backend;
        }
    }
}

TEST(GameScene, GivesOtherGamesForOtherSeeds)
{
    Game one(GameMode::zen, 1), two(GameMode::zen, 2);
    one.simulation().advance(600);
    two.simulation().advance(600);
    EXPECT_NE(one.simulation().state_hash(), two.simulation().state_hash());
}

TEST(GameScene, NeedsTheModelsOfItsFruit)
{
    const auto models = std::make_shared<sim::ModelLibrary>();
    EXPECT_THROW(make_scene("zen", models), std::invalid_argument);
    EXPECT_THROW(make_scene("chess", models), std::invalid_argument);
    for (const std::string& name : scene_names()) EXPECT_EQ(make_scene(name, test::fruit_library())->name(), name);
}

TEST(Autopilot, CutsFruitAndLeavesBombsAlone)
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        Game game(GameMode::arcade, seed);
        play_with_autopilot(game, 61 * sim::kTicksPerSecond);
        const GameState& state = game.state();
        const auto bombs = std::ranges::count(game.events(Kind::thrown), FruitKind::bomb,
                                              [](const GameEvent& event) { return event.fruit; });
        EXPECT_GT(state.counts.fruit_cut, 5 * state.counts.fruit_missed) << seed;
        EXPECT_GE(bombs, 3) << seed;
        EXPECT_LE(state.counts.bombs_cut, bombs / 3) << seed;
    }
}

}  // namespace kerf::game
