#include "viewer/game/waves.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "viewer/sim/camera.h"

namespace kerf::game {
namespace {

bool are_equal(const Wave& a, const Wave& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const PlannedThrow& x, const PlannedThrow& y) {
        return x.after == y.after && x.kind == y.kind && x.flight.centre == y.flight.centre &&
               x.flight.rotation == y.flight.rotation && x.flight.motion.velocity == y.flight.motion.velocity &&
               x.flight.motion.spin == y.flight.motion.spin;
    });
}

int count(const Wave& wave, FruitKind kind)
{
    return int(std::count_if(wave.begin(), wave.end(), [&](const PlannedThrow& t) { return t.kind == kind; }));
}

bool is_ordinary(const PlannedThrow& what)
{
    return fruit_of(what.kind).weight > 0;
}

double mean_fruit(GameMode mode, int number)
{
    constexpr int kWaves = 200;
    std::size_t fruit = 0;
    for (std::uint64_t seed = 0; seed < kWaves; ++seed) fruit += plan_wave(mode, number, seed).size();
    return double(fruit) / kWaves;
}

// Highest point of a flight by small steps.
double apex_by_steps(const sim::Flight& flight)
{
    double y = flight.centre.y, v = flight.motion.velocity.y, highest = y;
    constexpr double kStep = 1e-4;  // seconds
    while (v > 0.0) {
        y += v * kStep;
        highest = std::max(highest, y);
        v -= kGameGravity * kStep;
    }
    return highest;
}

}  // namespace

RC_GTEST_PROP(Waves, AreTheSameForTheSameSeed, (std::uint64_t seed))
{
    const GameMode mode = *rc::gen::elementOf(kGameModes);
    const int number = *rc::gen::inRange(1, 60);
    RC_ASSERT(are_equal(plan_wave(mode, number, seed), plan_wave(mode, number, seed)));
    RC_ASSERT(!are_equal(plan_wave(mode, number, seed), plan_wave(mode, number, seed + 1)));
}

RC_GTEST_PROP(Waves, KeepToTheirLineOfTheTable, (std::uint64_t seed))
{
    const GameMode mode = *rc::gen::elementOf(kGameModes);
    const int number = *rc::gen::inRange(1, 60);
    const Difficulty& line = difficulty_of(mode, number);
    const Wave wave = plan_wave(mode, number, seed);
    const int fruit = int(std::count_if(wave.begin(), wave.end(), is_ordinary));
    RC_ASSERT(fruit >= line.least_fruit && fruit <= line.most_fruit);
    const int bombs = count(wave, FruitKind::bomb);
    RC_ASSERT(bombs <= (line.bomb_percent > 0 ? line.most_bombs : 0));
    const int specials = int(wave.size()) - fruit - bombs;
    RC_ASSERT(specials <= (line.special_percent > 0 ? 1 : 0));
    RC_ASSERT(wave.front().after == 0);
    RC_ASSERT(std::is_sorted(wave.begin(), wave.end(),
                             [](const PlannedThrow& a, const PlannedThrow& b) { return a.after < b.after; }));
}

RC_GTEST_PROP(Waves, FlyToTheUpperThirdAndBackInside, (std::uint64_t seed))
{
    for (const PlannedThrow& what : plan_wave(*rc::gen::elementOf(kGameModes), *rc::gen::inRange(1, 60), seed)) {
        const double radius = fruit_of(what.kind).radius;
        RC_ASSERT(what.flight.centre.y + radius < -sim::kStageHalfHeight);
        const double apex = apex_by_steps(what.flight);
        RC_ASSERT(std::abs(apex - what.flight.apex) < 0.01);
        RC_ASSERT(apex > sim::kStageHalfHeight / 3.0);
        RC_ASSERT(apex < sim::kStageHalfHeight);
        const double time = 2.0 * what.flight.motion.velocity.y / kGameGravity;
        const double landing = what.flight.centre.x + time * what.flight.motion.velocity.x;
        RC_ASSERT(std::abs(landing) < sim::kStageHalfWidth);
    }
}

RC_GTEST_PROP(Waves, ThrowNothingIntoEachOther, (std::uint64_t seed))
{
    const Wave wave = plan_wave(*rc::gen::elementOf(kGameModes), *rc::gen::inRange(1, 60), seed);
    for (std::size_t i = 0; i < wave.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            if (wave[i].after != wave[j].after) continue;
            RC_ASSERT(std::abs(wave[i].flight.centre.x - wave[j].flight.centre.x) >
                      fruit_of(wave[i].kind).radius + fruit_of(wave[j].kind).radius);
        }
}

TEST(Waves, GetHarder)
{
    for (const GameMode mode : kGameModes) {
        double last = 0.0;
        for (const Difficulty& line : difficulties(mode)) {
            const double fruit = mean_fruit(mode, line.from_wave);
            EXPECT_GT(fruit, last) << name_of(mode) << " from wave " << line.from_wave;
            last = fruit;
        }
        EXPECT_EQ(difficulties(mode).front().from_wave, 1);
    }
}

TEST(Waves, HoldBombsAndSpecialsWhereTheyBelong)
{
    for (const GameMode mode : kGameModes) {
        using enum FruitKind;
        constexpr std::array kSpecials{freeze, frenzy, double_points, hammer, frozen};
        int bombs = 0;
        std::array<int, kSpecials.size()> specials{};
        for (int number = 1; number <= 300; ++number) {
            const Wave wave = plan_wave(mode, number, std::uint64_t(number));
            bombs += count(wave, FruitKind::bomb);
            for (std::size_t i = 0; i < specials.size(); ++i) specials[i] += count(wave, kSpecials[i]);
        }
        EXPECT_EQ(bombs > 0, mode != GameMode::zen) << name_of(mode);
        for (const int special : specials) EXPECT_EQ(special > 0, mode == GameMode::arcade) << name_of(mode);
    }
}

TEST(Waves, BringEveryFruit)
{
    int fruit[kFruitKinds] = {};
    for (std::uint64_t seed = 0; seed < 300; ++seed)
        for (const PlannedThrow& what : plan_wave(GameMode::arcade, 20, seed)) ++fruit[int(what.kind)];
    for (const Fruit& kind : fruit_catalogue()) EXPECT_GT(fruit[int(kind.kind)], 0) << kind.name;
}

TEST(Waves, MakeVolleysForCombos)
{
    int volleys = 0;
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        const Wave wave = plan_wave(GameMode::classic, 20, seed);
        const auto at_once = std::count_if(wave.begin(), wave.end(), [](const auto& t) { return t.after == 0; });
        volleys += at_once >= 3 ? 1 : 0;
    }
    EXPECT_GT(volleys, 20);
    EXPECT_LT(volleys, 180);
}

RC_GTEST_PROP(Frenzy, ComesFromBothSidesInTurn, (std::uint64_t seed))
{
    for (std::uint64_t number = 0; number < 2; ++number) {
        const PlannedThrow what = plan_frenzy_throw(number, seed);
        RC_ASSERT(is_ordinary(what));
        const double side = number == 0 ? -1.0 : 1.0;
        RC_ASSERT(side * what.flight.centre.x >= sim::kStageHalfWidth + fruit_of(what.kind).radius);
        RC_ASSERT(side * what.flight.motion.velocity.x < 0.0);
        const double apex = apex_by_steps(what.flight);
        RC_ASSERT(apex > sim::kStageHalfHeight / 3.0 && apex < sim::kStageHalfHeight);
        // On stage at its apex.
        const double x =
            what.flight.centre.x + what.flight.motion.velocity.x * what.flight.motion.velocity.y / kGameGravity;
        RC_ASSERT(std::abs(x) < sim::kStageHalfWidth);
    }
}

}  // namespace kerf::game
