#include <gtest/gtest.h>

#include <set>

#include "viewer/game/games.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/script.h"

// Whole games with the game's own fruit from recorded input, from the first tick to the last: some seconds of swipes,
// then nobody plays on. The seeds of the short ones are chosen so that all back ends agree on the score; where pieces
// touch, their positions part in the last digit.

namespace kerf::game {
namespace {

struct Outcome
{
    GameMode mode;
    double seconds;  // after which the game is over
    std::int64_t score, fruit_cut, criticals, combos;
    std::size_t specials;
    GameEnd end;
};

void PrintTo(const Outcome& outcome, std::ostream* out)
{
    *out << name_of(outcome.mode);
}

class ScriptedGame : public testing::TestWithParam<Outcome>
{
protected:
    // Plays the recording with a back end until the game is over, at the latest after so many seconds.
    static test::Game play(const Outcome& expected, const std::string& backend)
    {
        const sim::Script script =
            sim::read_script(KERF_SCRIPTS_DIR "/" + std::string(name_of(expected.mode)) + ".kerf");
        test::Game game(expected.mode, script.seed.value(), backend, test::real_fruit());
        game.simulation().push(script.events);
        game.play_until([&] { return game.is_over(); }, sim::Tick(expected.seconds * double(sim::kTicksPerSecond)));
        return game;
    }
};

}  // namespace

TEST_P(ScriptedGame, EndsWithItsScore)
{
    const Outcome& expected = GetParam();
    for (const std::string& backend : sim::backend_names()) {
        SCOPED_TRACE(backend);
        const test::Game game = play(expected, backend);
        const GameState& state = game.state();
        EXPECT_EQ(state.phase, GamePhase::over);
        EXPECT_EQ(state.end, expected.end);
        EXPECT_EQ(state.score, expected.score);
        EXPECT_EQ(state.fruit_cut, expected.fruit_cut);
        EXPECT_EQ(state.criticals, expected.criticals);
        EXPECT_EQ(state.combos, expected.combos);
        EXPECT_EQ(game.events(GameEventKind::special_started).size(), expected.specials);
        EXPECT_EQ(game.events(GameEventKind::game_over).size(), 1u);
        std::int64_t sum = 0;
        for (const GameEvent& event : game.scene().events())
            if (event.kind != GameEventKind::game_over) sum += event.points;
        EXPECT_EQ(sum, expected.score) << "the events add up";
    }
}

TEST_P(ScriptedGame, EndsInTheSameStateTwice)
{
    for (const std::string& backend : {sim::backend_names().front(), sim::backend_names().back()})
        EXPECT_EQ(play(GetParam(), backend).simulation().state_hash(),
                  play(GetParam(), backend).simulation().state_hash());
}

INSTANTIATE_TEST_SUITE_P(Modes, ScriptedGame,
                         testing::Values(Outcome{GameMode::classic, 60.0, 46, 20, 4, 1, 0, GameEnd::missed},
                                         Outcome{GameMode::arcade, 75.0, 91, 46, 6, 1, 2, GameEnd::time},
                                         Outcome{GameMode::zen, 90.5, 79, 37, 6, 1, 0, GameEnd::time}),
                         [](const auto& each) { return std::string(name_of(each.param.mode)); });

namespace {

// A game of dozens of fruit, with the back end that it was recorded with.
struct LongGame
{
    const char* script;
    std::int64_t score, fruit_cut, criticals, combos;
};

void PrintTo(const LongGame& game, std::ostream* out)
{
    *out << game.script;
}

class LongScriptedGame : public testing::TestWithParam<LongGame>
{
protected:
    // Plays the recording until the game is over, at the latest after a minute and a half.
    test::Game play(const std::string& backend) const
    {
        const GameMode mode = script_.scene == name_of(GameMode::classic) ? GameMode::classic : GameMode::arcade;
        test::Game game(mode, script_.seed.value(), backend, test::real_fruit());
        game.simulation().push(script_.events);
        game.play_until([&] { return game.is_over(); }, 90 * sim::kTicksPerSecond);
        return game;
    }

    const sim::Script script_ = sim::read_script(KERF_SCRIPTS_DIR "/" + std::string(GetParam().script) + ".kerf");
};

// The points of all events before one of them.
std::int64_t points_before(const test::Game& game, const GameEvent& event)
{
    std::int64_t sum = 0;
    for (const GameEvent& each : game.scene().events()) {
        if (each.tick >= event.tick) break;
        sum += each.points;
    }
    return sum;
}

class LongClassicGame : public LongScriptedGame
{
};

class LongArcadeGame : public LongScriptedGame
{
};

}  // namespace

TEST_P(LongScriptedGame, EndsWithItsScore)
{
    const LongGame& expected = GetParam();
    const test::Game game = play(script_.backend);
    const GameState& state = game.state();
    EXPECT_EQ(state.phase, GamePhase::over);
    EXPECT_EQ(state.score, expected.score);
    EXPECT_EQ(state.fruit_cut, expected.fruit_cut);
    EXPECT_EQ(state.criticals, expected.criticals);
    EXPECT_EQ(state.combos, expected.combos);
    EXPECT_EQ(state.longest_combo, 3);
}

TEST_P(LongScriptedGame, RunsToItsEndWithTheOtherBackEndsToo)
{
    for (const std::string& backend : sim::backend_names()) {
        SCOPED_TRACE(backend);
        const test::Game game = play(backend);
        EXPECT_EQ(game.state().phase, GamePhase::over);
        EXPECT_GT(game.state().score, 0);
    }
}

TEST_P(LongClassicGame, HasAnExtraLifeAndEndsWithABomb)
{
    const test::Game game = play(script_.backend);
    EXPECT_EQ(game.state().end, GameEnd::bomb);
    const std::vector<GameEvent> extra_lives = game.events(GameEventKind::extra_life);
    ASSERT_EQ(extra_lives.size(), 1u);
    EXPECT_LT(points_before(game, extra_lives[0]), 100) << "the life came with the hundredth point";
    EXPECT_GT(game.state().score, 100);
}

TEST_P(LongArcadeGame, PaysForABombAndHasEachSpecialAndEndsWithTheTime)
{
    const test::Game game = play(script_.backend);
    EXPECT_EQ(game.state().end, GameEnd::time);
    const std::vector<GameEvent> bombs = game.events(GameEventKind::bomb);
    ASSERT_EQ(bombs.size(), 1u);
    EXPECT_EQ(bombs[0].points, -10);
    EXPECT_GE(points_before(game, bombs[0]), 10);
    std::set<FruitKind> specials;
    for (const GameEvent& event : game.events(GameEventKind::special_started)) specials.insert(event.fruit.value());
    EXPECT_EQ(specials, (std::set{FruitKind::freeze, FruitKind::frenzy, FruitKind::double_points}));
}

namespace {

constexpr LongGame kClassicHalfedge{"classic_bomb_halfedge", 117, 55, 9, 1};
constexpr LongGame kClassicBaseline{"classic_bomb_baseline", 121, 54, 10, 1};
constexpr LongGame kArcadeHalfedge{"arcade_specials_halfedge", 249, 73, 17, 1};
constexpr LongGame kArcadeBaseline{"arcade_specials_baseline", 253, 72, 17, 1};

constexpr auto kScriptsName = [](const testing::TestParamInfo<LongGame>& each) {
    return std::string(each.param.script);
};

}  // namespace

// Each ends as recorded, or, with another back end, because there is nobody who plays on.
INSTANTIATE_TEST_SUITE_P(Recorded, LongScriptedGame,
                         testing::Values(kClassicHalfedge, kClassicBaseline, kArcadeHalfedge, kArcadeBaseline),
                         kScriptsName);
INSTANTIATE_TEST_SUITE_P(Recorded, LongClassicGame, testing::Values(kClassicHalfedge, kClassicBaseline), kScriptsName);
INSTANTIATE_TEST_SUITE_P(Recorded, LongArcadeGame, testing::Values(kArcadeHalfedge, kArcadeBaseline), kScriptsName);

}  // namespace kerf::game
