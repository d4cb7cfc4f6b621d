#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

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
    std::int64_t score;
    GameEnd end;
};

void PrintTo(const Outcome& outcome, std::ostream* out)
{
    *out << name_of(outcome.mode);
}

std::int64_t count_of(const test::Game& game, GameEventKind kind)
{
    return std::int64_t(game.events(kind).size());
}

void expect_score_adds_up(const test::Game& game)
{
    std::int64_t score = 0;
    for (const GameEvent& event : game.scene().events()) {
        if (event.kind != GameEventKind::game_over) score += event.points;
        EXPECT_GE(score, 0) << "at tick " << event.tick;
    }
    EXPECT_EQ(game.state().score, score);
    EXPECT_GT(score, 0);
}

void expect_counts_are_those_of_events(const test::Game& game)
{
    const GameState& state = game.state();
    EXPECT_EQ(state.counts.fruit_cut, count_of(game, GameEventKind::fruit_cut));
    EXPECT_EQ(state.counts.fruit_missed, count_of(game, GameEventKind::missed));
    EXPECT_EQ(state.counts.criticals, count_of(game, GameEventKind::critical));
    EXPECT_EQ(state.counts.combos, count_of(game, GameEventKind::combo));
    EXPECT_EQ(state.counts.bombs_cut, count_of(game, GameEventKind::bomb));
    EXPECT_EQ(state.wave, count_of(game, GameEventKind::wave));
    int longest = 0;
    for (const GameEvent& combo : game.events(GameEventKind::combo)) longest = std::max(longest, combo.count);
    EXPECT_EQ(state.counts.longest_combo, longest);
}

void expect_lives_are_counted(const test::Game& game)
{
    int lives = game.state().lives_at_start;
    for (const GameEvent& event : game.scene().events()) {
        if (event.kind == GameEventKind::life_lost) --lives;
        if (event.kind == GameEventKind::extra_life) ++lives;
        if (event.kind == GameEventKind::life_lost || event.kind == GameEventKind::extra_life) {
            EXPECT_EQ(event.count, lives);
        }
    }
    EXPECT_EQ(game.state().lives, lives);
    EXPECT_GE(lives, 0);
}

/// Each object is thrown once, and then cut or missed at most once.
void expect_objects_have_one_life(const test::Game& game)
{
    std::set<sim::ObjectId> thrown, ended;
    for (const GameEvent& event : game.scene().events()) {
        if (event.kind == GameEventKind::thrown) {
            EXPECT_TRUE(thrown.insert(event.object).second);
        }
        if (event.kind == GameEventKind::fruit_cut || event.kind == GameEventKind::bomb ||
            event.kind == GameEventKind::missed) {
            EXPECT_TRUE(thrown.contains(event.object));
            EXPECT_TRUE(ended.insert(event.object).second);
        }
    }
    EXPECT_GT(ended.size(), 20u);
}

void expect_one_end(const test::Game& game)
{
    EXPECT_EQ(game.state().phase, GamePhase::over);
    EXPECT_EQ(count_of(game, GameEventKind::game_over), 1);
    const GameEvent& last = game.scene().events().back();
    EXPECT_EQ(last.kind, GameEventKind::game_over) << "nothing counts after the end";
    EXPECT_EQ(last.points, game.state().score);
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
        EXPECT_EQ(game.state().end, expected.end);
        EXPECT_EQ(game.state().score, expected.score);
        expect_one_end(game);
        expect_score_adds_up(game);
        expect_counts_are_those_of_events(game);
        expect_lives_are_counted(game);
        expect_objects_have_one_life(game);
    }
}

TEST_P(ScriptedGame, EndsInTheSameStateTwice)
{
    for (const std::string& backend : {sim::backend_names().front(), sim::backend_names().back()})
        EXPECT_EQ(play(GetParam(), backend).simulation().state_hash(),
                  play(GetParam(), backend).simulation().state_hash());
}

INSTANTIATE_TEST_SUITE_P(Modes, ScriptedGame,
                         testing::Values(Outcome{GameMode::classic, 60.0, 46, GameEnd::missed},
                                         Outcome{GameMode::arcade, 75.0, 85, GameEnd::time},
                                         Outcome{GameMode::zen, 90.5, 75, GameEnd::time}),
                         [](const auto& each) { return std::string(name_of(each.param.mode)); });

namespace {

// Games of dozens of fruit. Their moves depend on the last digits of floats where pieces touch, and those on the
// compiler; what the rules say of a game does not.

/// The points of all events before a tick.
std::int64_t points_before(const test::Game& game, sim::Tick tick)
{
    std::int64_t sum = 0;
    for (const GameEvent& each : game.scene().events()) {
        if (each.tick >= tick) break;
        sum += each.points;
    }
    return sum;
}

class LongScriptedGame : public testing::TestWithParam<std::string>
{
protected:
    // Plays a recording until the game is over, at the latest after a minute and a half.
    static test::Game play(const std::string& name, const std::string& backend)
    {
        const sim::Script script = sim::read_script(KERF_SCRIPTS_DIR "/" + name + ".kerf");
        const GameMode mode = script.scene == name_of(GameMode::classic) ? GameMode::classic : GameMode::arcade;
        test::Game game(mode, script.seed.value(), backend, test::real_fruit());
        game.simulation().push(script.events);
        game.play_until([&] { return game.is_over(); }, 90 * sim::kTicksPerSecond);
        return game;
    }
};

}  // namespace

TEST_P(LongScriptedGame, KeepsTheRulesInClassic)
{
    const test::Game game = play("classic_bomb", GetParam());
    expect_one_end(game);
    expect_score_adds_up(game);
    expect_counts_are_those_of_events(game);
    expect_lives_are_counted(game);
    expect_objects_have_one_life(game);
    EXPECT_TRUE(game.state().end == GameEnd::bomb || game.state().lives == 0);
    for (const GameEvent& life : game.events(GameEventKind::extra_life))
        EXPECT_LT(points_before(game, life.tick) / 100, points_before(game, life.tick + 1) / 100)
            << "a life comes with each hundredth point";
}

TEST_P(LongScriptedGame, KeepsTheRulesInArcade)
{
    const test::Game game = play("arcade_specials", GetParam());
    expect_one_end(game);
    expect_score_adds_up(game);
    expect_counts_are_those_of_events(game);
    expect_lives_are_counted(game);
    expect_objects_have_one_life(game);
    EXPECT_EQ(game.state().end, GameEnd::time);
    for (const GameEvent& bomb : game.events(GameEventKind::bomb))
        EXPECT_EQ(bomb.points, -std::min<std::int64_t>(10, points_before(game, bomb.tick)));
    std::set<FruitKind> started;
    for (const GameEvent& event : game.events(GameEventKind::special_started)) started.insert(event.fruit.value());
    EXPECT_FALSE(started.empty());
}

INSTANTIATE_TEST_SUITE_P(BackEnds, LongScriptedGame,
                         testing::Values(sim::backend_names().front(), sim::backend_names().back()),
                         [](const auto& each) { return each.index == 0 ? "first" : "last"; });

}  // namespace kerf::game
