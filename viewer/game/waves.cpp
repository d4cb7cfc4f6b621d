#include "viewer/game/waves.h"

#include <algorithm>
#include <cmath>

#include "common/support/random.h"
#include "viewer/sim/camera.h"

namespace kerf::game {
namespace {

// from  fruit   gap  volley bombs most special pause longest
constexpr std::array<Difficulty, 7> kClassic{{
    {1, 1, 1, 60, 0, 0, 1, 0, 60, 300},
    {3, 2, 2, 45, 30, 0, 1, 0, 60, 300},
    {5, 2, 3, 40, 35, 15, 1, 0, 60, 300},
    {8, 3, 4, 30, 40, 30, 1, 0, 50, 300},
    {12, 3, 5, 24, 45, 40, 1, 0, 45, 240},
    {18, 4, 6, 18, 50, 55, 2, 0, 40, 200},
    {26, 5, 8, 14, 55, 70, 2, 0, 30, 160},
}};
constexpr std::array<Difficulty, 4> kArcade{{
    {1, 2, 3, 24, 40, 0, 1, 0, 30, 150},
    {3, 3, 5, 18, 50, 25, 1, 30, 30, 130},
    {8, 4, 6, 15, 55, 40, 1, 33, 24, 110},
    {14, 5, 8, 12, 60, 55, 2, 36, 20, 90},
}};
constexpr std::array<Difficulty, 4> kZen{{
    {1, 2, 3, 30, 50, 0, 0, 0, 40, 150},
    {4, 3, 5, 20, 55, 0, 0, 0, 30, 130},
    {10, 4, 7, 15, 60, 0, 0, 0, 24, 110},
    {18, 6, 9, 12, 65, 0, 0, 0, 20, 90},
}};

/// What a wave holds one of where Difficulty::special_percent says so, all of them as often.
constexpr std::array<FruitKind, 5> kThrownSpecials{FruitKind::freeze, FruitKind::frenzy, FruitKind::double_points,
                                                   FruitKind::hammer, FruitKind::frozen};

/// Room between two fruit that start at once, metres beyond what their boxes take.
constexpr double kElbowRoom = 0.1;
/// Tries to find a place with room.
constexpr int kTries = 12;

// What comes from the sides (frenzy).
/// Height of the start, shares of the stage's half height: in the lower half.
constexpr double kLowestSide = -0.6, kHighestSide = -0.2;
/// Height of the apex: in the upper third, lower than that of others because half the flight is over at the start.
constexpr double kLowestSideApex = 0.35, kHighestSideApex = 0.6;
/// Where it crosses the height of its start again, shares of the half width beyond the middle.
constexpr double kNearestSideLanding = 0.1, kFarthestSideLanding = 0.7;

bool chance(core::Random& random, int percent)
{
    return random.below(100) < std::uint32_t(percent);
}

int between(core::Random& random, int least, int most)
{
    return least + int(random.below(std::uint32_t(most - least + 1)));
}

double between(core::Random& random, double low, double high)
{
    return low + (high - low) * random.unit();
}

FruitKind draw_fruit(core::Random& random)
{
    int sum = 0;
    for (const Fruit& fruit : fruit_catalogue()) sum += fruit.weight;
    int left = int(random.below(std::uint32_t(sum)));
    for (const Fruit& fruit : fruit_catalogue()) {
        if (left < fruit.weight) return fruit.kind;
        left -= fruit.weight;
    }
    return FruitKind::apple;
}

std::vector<FruitKind> draw_kinds(core::Random& random, const Difficulty& difficulty)
{
    std::vector<FruitKind> kinds;
    const int fruit = between(random, difficulty.least_fruit, difficulty.most_fruit);
    for (int i = 0; i < fruit; ++i) kinds.push_back(draw_fruit(random));
    if (chance(random, difficulty.special_percent))
        kinds.push_back(kThrownSpecials[random.below(kThrownSpecials.size())]);
    if (chance(random, difficulty.bomb_percent))
        kinds.insert(kinds.end(), std::size_t(between(random, 1, difficulty.most_bombs)), FruitKind::bomb);
    // Bombs and specials come anywhere in the wave, not at its end.
    for (std::size_t i = kinds.size(); i > 1; --i) std::swap(kinds[i - 1], kinds[random.below(std::uint32_t(i))]);
    return kinds;
}

bool has_room(const PlannedThrow& wanted, const Wave& wave)
{
    const double radius = fruit_of(wanted.kind).radius;
    return std::all_of(wave.begin(), wave.end(), [&](const PlannedThrow& other) {
        return other.after != wanted.after || std::abs(other.flight.centre.x - wanted.flight.centre.x) >=
                                                  radius + fruit_of(other.kind).radius + kElbowRoom;
    });
}

}  // namespace

std::span<const Difficulty> difficulties(GameMode mode)
{
    switch (mode) {
        case GameMode::classic:
            return kClassic;
        case GameMode::arcade:
            return kArcade;
        case GameMode::zen:
            return kZen;
    }
    return kClassic;
}

const Difficulty& difficulty_of(GameMode mode, int wave)
{
    const std::span<const Difficulty> table = difficulties(mode);
    std::size_t line = 0;
    while (line + 1 < table.size() && table[line + 1].from_wave <= wave) ++line;
    return table[line];
}

Wave plan_wave(GameMode mode, int number, std::uint64_t seed)
{
    const Difficulty& difficulty = difficulty_of(mode, number);
    core::Random random(seed);
    const bool is_volley = chance(random, difficulty.volley_percent);
    const std::vector<FruitKind> kinds = draw_kinds(random, difficulty);

    Wave wave;
    sim::Tick after = 0;
    for (const FruitKind kind : kinds) {
        PlannedThrow next{after, kind, {}};
        for (int i = 0; i < kTries; ++i) {
            next.flight = sim::plan_flight(random.next(), kGameGravity, fruit_of(kind).radius);
            if (has_room(next, wave)) break;
        }
        // Where there is no room the fruit waits until the others are out of its way.
        if (!has_room(next, wave)) next.after = after += difficulty.gap;
        wave.push_back(next);
        if (!is_volley) after += difficulty.gap;
    }
    return wave;
}

PlannedThrow plan_frenzy_throw(std::uint64_t number, std::uint64_t seed)
{
    core::Random random(seed);
    PlannedThrow next;
    next.kind = draw_fruit(random);
    const double radius = fruit_of(next.kind).radius;
    // The rotation and the direction of the spin of an ordinary throw; everything else is from the side.
    next.flight = sim::plan_flight(random.next(), kGameGravity, radius);
    const double side = number % 2 == 0 ? -1.0 : 1.0;
    const double start = side * (sim::kStageHalfWidth + radius);
    const double landing = -side * between(random, kNearestSideLanding, kFarthestSideLanding) * sim::kStageHalfWidth;
    const double height = between(random, kLowestSide, kHighestSide) * sim::kStageHalfHeight;
    next.flight.apex = between(random, kLowestSideApex, kHighestSideApex) * sim::kStageHalfHeight;
    next.flight.centre = {start, height, 0.0};
    const double up = std::sqrt(2.0 * kGameGravity * (next.flight.apex - height));
    next.flight.motion.velocity = {(landing - start) * kGameGravity / (2.0 * up), up, 0.0};
    return next;
}

}  // namespace kerf::game
