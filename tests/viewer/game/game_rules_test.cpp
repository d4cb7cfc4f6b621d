#include "viewer/game/game_rules.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

namespace kerf::game {
namespace {

using enum FruitKind;
using Kind = GameEventKind;

// A game whose player is a test: one swipe a cut unless said otherwise.
class Table
{
public:
    explicit Table(GameMode mode, std::int64_t best = 0) : rules(mode, best) {}

    void wait(sim::Tick ticks)
    {
        for (sim::Tick i = 0; i < ticks; ++i) rules.tick(++now_, swipe_, false);
    }
    void cut(FruitKind kind, double lighter_share = 0.2)
    {
        ++swipe_;
        cut_in_swipe(kind, lighter_share);
        wait(1);
    }
    // As part of a swipe that goes on.
    void cut_in_swipe(FruitKind kind, double lighter_share = 0.2)
    {
        Cut what;
        what.kind = kind;
        what.tick = now_;
        what.swipe = swipe_;
        what.lighter_share = lighter_share;
        what.object = ++objects_;
        rules.cut(what);
    }
    void swipe_through(int apples)
    {
        ++swipe_;
        for (int i = 0; i < apples; ++i) cut_in_swipe(apple);
        wait(1);
    }
    void miss(FruitKind kind) { rules.gone(now_, kind, {}, ++objects_); }
    void score(std::int64_t points)
    {
        while (state().score < points) cut(apple);
    }

    const GameState& state() const { return rules.state(); }
    std::vector<GameEvent> events(Kind kind) const
    {
        std::vector<GameEvent> found;
        for (const GameEvent& event : rules.events())
            if (event.kind == kind) found.push_back(event);
        return found;
    }
    bool is_over() const { return rules.is_over(); }

    GameRules rules;

private:
    sim::Tick now_ = 0;
    std::uint32_t swipe_ = 0;
    sim::ObjectId objects_ = 0;
};

constexpr sim::Tick seconds(double s)
{
    return sim::Tick(s * double(sim::kTicksPerSecond));
}

}  // namespace

TEST(GameRules, PayEachFruitWhatTheCatalogueSays)
{
    for (const Fruit& fruit : fruit_catalogue()) {
        if (fruit.kind == bomb) continue;
        Table table(GameMode::arcade);
        table.cut(fruit.kind);
        EXPECT_EQ(table.state().score, fruit.points) << fruit.name;
        ASSERT_EQ(table.events(Kind::fruit_cut).size(), 1u);
        EXPECT_EQ(table.events(Kind::fruit_cut)[0].points, fruit.points);
        EXPECT_EQ(table.events(Kind::fruit_cut)[0].fruit, fruit.kind);
    }
}

TEST(GameRules, PayACriticalCutMore)
{
    Table table(GameMode::classic);
    table.cut(apple, kCriticalShare);
    EXPECT_EQ(table.state().score, 1 + kCriticalPoints);
    EXPECT_EQ(table.state().counts.criticals, 1);
    ASSERT_EQ(table.events(Kind::critical).size(), 1u);
    table.cut(apple, kCriticalShare - 0.001);
    EXPECT_EQ(table.state().counts.criticals, 1);
}

TEST(GameRules, PayACombosFruitAgain)
{
    Table table(GameMode::zen);
    table.swipe_through(2);
    EXPECT_EQ(table.state().score, 2);
    table.swipe_through(3);
    EXPECT_EQ(table.state().score, 2 + 3 + 3);
    table.swipe_through(5);
    EXPECT_EQ(table.state().score, 8 + 5 + 5);
    EXPECT_EQ(table.state().counts.combos, 2);
    EXPECT_EQ(table.state().counts.longest_combo, 5);
    const auto combos = table.events(Kind::combo);
    ASSERT_EQ(combos.size(), 2u);
    EXPECT_EQ(combos[0].count, 3);
    EXPECT_EQ(combos[1].points, 5);
}

TEST(GameRules, ShowTheComboWhileItGrows)
{
    Table table(GameMode::zen);
    table.cut_in_swipe(apple);
    table.cut_in_swipe(kiwi);
    EXPECT_EQ(table.state().combo, 2);
    table.wait(1);
    EXPECT_EQ(table.state().combo, 0);
}

TEST(GameRules, KeepBombsOutOfCombos)
{
    Table table(GameMode::arcade);
    table.cut_in_swipe(apple);
    table.cut_in_swipe(bomb);
    table.cut_in_swipe(apple);
    table.wait(1);
    EXPECT_EQ(table.state().counts.combos, 0);
}

TEST(Classic, EndsAfterThreeMisses)
{
    Table table(GameMode::classic);
    EXPECT_EQ(table.state().lives, 3);
    table.miss(apple);
    table.miss(kiwi);
    EXPECT_EQ(table.state().lives, 1);
    EXPECT_FALSE(table.is_over());
    table.miss(banana);
    EXPECT_TRUE(table.is_over());
    EXPECT_EQ(table.state().end, GameEnd::missed);
    EXPECT_EQ(table.events(Kind::life_lost).size(), 3u);
    EXPECT_EQ(table.events(Kind::missed).size(), 3u);
    EXPECT_EQ(table.events(Kind::game_over).size(), 1u);
}

TEST(Classic, EndsWithABomb)
{
    Table table(GameMode::classic);
    table.cut(apple);
    table.cut(bomb);
    EXPECT_TRUE(table.is_over());
    EXPECT_EQ(table.state().end, GameEnd::bomb);
    EXPECT_EQ(table.state().score, 1);
    EXPECT_EQ(table.events(Kind::game_over)[0].points, 1);
}

TEST(Classic, PaysAComboThatABombEnds)
{
    Table table(GameMode::classic);
    for (int i = 0; i < 3; ++i) table.cut_in_swipe(apple);
    table.cut_in_swipe(bomb);
    EXPECT_EQ(table.state().score, 6);
    EXPECT_EQ(table.rules.events().back().kind, Kind::game_over);
    EXPECT_EQ(table.rules.events().back().points, 6);
}

TEST(Classic, ForgivesABombThatIsLeftAlone)
{
    Table table(GameMode::classic);
    table.miss(bomb);
    EXPECT_EQ(table.state().lives, 3);
    EXPECT_TRUE(table.events(Kind::missed).empty());
}

TEST(Classic, GivesALifeForEachHundredPoints)
{
    Table table(GameMode::classic);
    table.miss(apple);
    table.score(99);
    EXPECT_EQ(table.state().lives, 2);
    table.score(100);
    EXPECT_EQ(table.state().lives, 3);
    table.score(199);
    EXPECT_EQ(table.state().lives, 3);
    table.score(200);
    EXPECT_EQ(table.state().lives, 4);
    ASSERT_EQ(table.events(Kind::extra_life).size(), 2u);
    EXPECT_EQ(table.events(Kind::extra_life)[1].count, 4);
}

TEST(Classic, KeepsNoMoreThanFiveLives)
{
    Table table(GameMode::classic);
    table.score(500);
    EXPECT_EQ(table.state().lives, kMostLives);
    EXPECT_EQ(table.events(Kind::extra_life).size(), 2u);
    table.miss(apple);
    table.score(599);
    EXPECT_EQ(table.state().lives, kMostLives - 1) << "lives that there was no room for are not kept for later";
}

TEST(Classic, HasNoClock)
{
    Table table(GameMode::classic);
    table.wait(seconds(600));
    EXPECT_FALSE(table.is_over());
    EXPECT_FALSE(table.state().seconds_left);
}

TEST(Arcade, LastsAMinute)
{
    Table table(GameMode::arcade);
    EXPECT_DOUBLE_EQ(*table.state().seconds_left, 60.0);
    table.wait(seconds(60) - 1);
    EXPECT_FALSE(table.is_over());
    table.wait(1);
    EXPECT_TRUE(table.is_over());
    EXPECT_EQ(table.state().end, GameEnd::time);
    EXPECT_DOUBLE_EQ(*table.state().seconds_left, 0.0);
}

TEST(Arcade, TakesTenPointsForABomb)
{
    Table table(GameMode::arcade);
    table.score(25);
    table.cut(bomb);
    EXPECT_EQ(table.state().score, 15);
    EXPECT_EQ(table.events(Kind::bomb)[0].points, -10);
    EXPECT_FALSE(table.is_over());
}

TEST(Arcade, NeverTakesMorePointsThanThereAre)
{
    Table table(GameMode::arcade);
    table.score(4);
    table.cut(bomb);
    EXPECT_EQ(table.state().score, 0);
    EXPECT_EQ(table.events(Kind::bomb)[0].points, -4);
}

TEST(Arcade, ForgivesMisses)
{
    Table table(GameMode::arcade);
    for (int i = 0; i < 10; ++i) table.miss(apple);
    table.miss(freeze);
    EXPECT_FALSE(table.is_over());
    EXPECT_EQ(table.state().counts.fruit_missed, 10);
    EXPECT_TRUE(table.events(Kind::life_lost).empty());
}

TEST(Arcade, CountsDoubleWhileItLasts)
{
    Table table(GameMode::arcade);
    table.cut(double_points);
    EXPECT_EQ(table.state().score, 1) << "the fruit itself counts once";
    EXPECT_EQ(table.state().multiplier, 2);
    table.cut(apple, kCriticalShare);
    EXPECT_EQ(table.state().score, 1 + 2 * (1 + kCriticalPoints));
    table.swipe_through(3);
    EXPECT_EQ(table.state().score, 1 + 2 * (1 + kCriticalPoints) + 2 * (3 + 3));
    table.wait(kDoubleTicks);
    const std::int64_t before = table.state().score;
    EXPECT_EQ(table.state().multiplier, 1);
    table.cut(apple);
    EXPECT_EQ(table.state().score, before + 1);
    EXPECT_EQ(table.events(Kind::special_ended).size(), 1u);
}

TEST(Arcade, StopsItsClockWhileFrozen)
{
    Table table(GameMode::arcade);
    table.wait(seconds(10));
    table.cut(freeze);
    const double left = *table.state().seconds_left;
    EXPECT_DOUBLE_EQ(table.rules.time_scale(), kFrozenTimeScale);
    table.wait(kFreezeTicks - 2);
    EXPECT_DOUBLE_EQ(*table.state().seconds_left, left);
    table.wait(1);
    EXPECT_DOUBLE_EQ(table.rules.time_scale(), 1.0);
    table.wait(seconds(1));
    EXPECT_NEAR(*table.state().seconds_left, left - 1.0, 2.0 * sim::kTickSeconds);
}

TEST(Arcade, FreezesForFiveSecondsOfThePlayers)
{
    Table table(GameMode::arcade);
    table.cut_in_swipe(freeze);
    ASSERT_EQ(table.state().specials.size(), 1u);
    EXPECT_EQ(table.state().specials[0].kind, freeze);
    EXPECT_DOUBLE_EQ(table.state().specials[0].seconds_left, 5.0);
    EXPECT_DOUBLE_EQ(table.state().specials[0].share_left, 1.0);
}

TEST(Arcade, SmashesAllFruitWhileTheHammerLasts)
{
    Table table(GameMode::arcade);
    EXPECT_FALSE(table.rules.smashes(apple));
    table.cut_in_swipe(hammer);
    ASSERT_EQ(table.events(Kind::special_started).size(), 1u);
    EXPECT_EQ(table.events(Kind::special_started)[0].fruit, hammer);
    ASSERT_EQ(table.state().specials.size(), 1u);
    EXPECT_EQ(table.state().specials[0].kind, hammer);
    EXPECT_DOUBLE_EQ(table.state().specials[0].seconds_left, 6.0);
    EXPECT_DOUBLE_EQ(table.state().specials[0].share_left, 1.0);
    for (const Fruit& fruit : fruit_catalogue())
        EXPECT_EQ(table.rules.smashes(fruit.kind), fruit.kind != bomb) << fruit.name;
    table.wait(kHammerTicks - 1);
    EXPECT_TRUE(table.rules.smashes(apple));
    table.wait(1);
    EXPECT_FALSE(table.rules.smashes(apple));
    EXPECT_TRUE(table.state().specials.empty());
    ASSERT_EQ(table.events(Kind::special_ended).size(), 1u);
    EXPECT_EQ(table.events(Kind::special_ended)[0].fruit, hammer);
}

TEST(Arcade, SmashesFrozenFruitAtAnyTime)
{
    Table table(GameMode::arcade);
    EXPECT_TRUE(table.rules.smashes(frozen));
    table.cut(frozen);
    EXPECT_EQ(table.state().score, 3);
    EXPECT_TRUE(table.events(Kind::special_started).empty()) << "it begins nothing";
}

TEST(Arcade, CallsNothingCriticalThatIsSmashed)
{
    Table table(GameMode::arcade);
    table.cut(frozen, 0.5);
    table.cut(hammer);
    table.cut(apple, 0.5);
    EXPECT_EQ(table.state().counts.criticals, 0);
    table.wait(kHammerTicks);
    table.cut(apple, 0.5);
    EXPECT_EQ(table.state().counts.criticals, 1);
}

TEST(Arcade, StartsASpecialAgainThatIsCutAgain)
{
    Table table(GameMode::arcade);
    table.cut(frenzy);
    table.wait(kFrenzyTicks / 2);
    table.cut(frenzy);
    table.wait(kFrenzyTicks - 2);
    EXPECT_TRUE(table.rules.is_active(frenzy));
    table.wait(1);
    EXPECT_FALSE(table.rules.is_active(frenzy));
    EXPECT_EQ(table.events(Kind::special_started).size(), 2u);
    EXPECT_EQ(table.events(Kind::special_ended).size(), 1u);
}

TEST(Arcade, KeepsSpecialsApart)
{
    Table table(GameMode::arcade);
    table.cut(double_points);
    table.cut(frenzy);
    table.cut(freeze);
    table.cut(hammer);
    EXPECT_EQ(table.state().specials.size(), 4u);
    table.wait(kFreezeTicks);
    EXPECT_FALSE(table.rules.is_active(freeze));
    EXPECT_TRUE(table.rules.is_active(frenzy));
    EXPECT_TRUE(table.rules.is_active(double_points));
    EXPECT_TRUE(table.rules.is_active(hammer));
}

TEST(Zen, LastsAMinuteAndAHalf)
{
    Table table(GameMode::zen);
    for (int i = 0; i < 5; ++i) table.miss(apple);
    table.wait(seconds(90) - 1);
    EXPECT_FALSE(table.is_over());
    table.wait(1);
    EXPECT_EQ(table.state().end, GameEnd::time);
}

TEST(GameOver, CountsNothingAnyMore)
{
    for (const GameMode mode : kGameModes) {
        Table table(mode);
        table.score(5);
        table.rules.give_up(99);
        EXPECT_EQ(table.state().end, GameEnd::given_up);
        const std::size_t events = table.rules.events().size();
        table.cut(apple, 0.5);
        table.cut(bomb);
        table.miss(apple);
        table.rules.start_wave(100);
        table.rules.give_up(100);
        table.wait(100);
        EXPECT_EQ(table.state().score, 5);
        EXPECT_EQ(table.rules.events().size(), events);
        EXPECT_EQ(table.state().end, GameEnd::given_up);
    }
}

TEST(GameOver, SaysWhetherTheBestIsBeaten)
{
    Table table(GameMode::zen, 3);
    EXPECT_EQ(table.state().best, 3);
    table.score(3);
    EXPECT_FALSE(table.state().is_best);
    table.score(4);
    EXPECT_TRUE(table.state().is_best);
    EXPECT_EQ(table.state().best, 4);
    Table first(GameMode::zen);
    first.score(4);
    EXPECT_FALSE(first.state().is_best) << "nothing is no record";
    EXPECT_EQ(first.state().best, 0);
}

RC_GTEST_PROP(GameRules, AddUpInTheirEvents, ())
{
    const GameMode mode = *rc::gen::elementOf(kGameModes);
    const auto actions = *rc::gen::resize(80, rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(
                                                  rc::gen::inRange(0, int(kFruitKinds) + 4), rc::gen::inRange(0, 60))));
    Table table(mode);
    for (const auto& [action, number] : actions) {
        if (action < int(kFruitKinds)) {
            table.cut(static_cast<FruitKind>(action), number / 120.0);
        } else if (action == int(kFruitKinds)) {
            table.swipe_through(number % 8);
        } else if (action == int(kFruitKinds) + 1) {
            table.miss(static_cast<FruitKind>(number % int(kFruitKinds)));
        } else {
            table.wait(number);
        }
    }
    std::int64_t sum = 0;
    for (const GameEvent& event : table.rules.events())
        if (event.kind != Kind::game_over) sum += event.points;
    RC_ASSERT(sum == table.state().score);
    RC_ASSERT(sum >= 0);
    RC_ASSERT(table.state().lives >= 0 && table.state().lives <= kMostLives);
    RC_ASSERT(std::is_sorted(table.rules.events().begin(), table.rules.events().end(),
                             [](const GameEvent& a, const GameEvent& b) { return a.tick < b.tick; }));
    RC_ASSERT(table.events(Kind::game_over).size() == (table.is_over() ? 1u : 0u));
}

}  // namespace kerf::game
