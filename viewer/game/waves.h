#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "viewer/game/fruit.h"
#include "viewer/game/game_mode.h"
#include "viewer/sim/thrower.h"

namespace kerf::game {

/// How hard a game is from a wave on: a line of its mode's table.
struct Difficulty
{
    int from_wave = 1;
    int least_fruit = 1, most_fruit = 1;
    sim::Tick gap = 60;       ///< between two throws
    int volley_percent = 0;   ///< of waves that are thrown all at once: food for combos
    int bomb_percent = 0;     ///< of waves with bombs
    int most_bombs = 1;       ///< in such a wave
    int special_percent = 0;  ///< of waves with a special or a frozen fruit
    sim::Tick pause = 90;     ///< after a wave, when nothing whole is left in the air
    sim::Tick longest = 300;  ///< after its last throw the next wave waits no longer than this
};

/// The table of a mode, its lines in order of from_wave, which begins at 1.
std::span<const Difficulty> difficulties(GameMode mode);
const Difficulty& difficulty_of(GameMode mode, int wave);

struct PlannedThrow
{
    sim::Tick after = 0;  ///< the start of its wave
    FruitKind kind = FruitKind::apple;
    sim::Flight flight;
};

/// Throws in the order of their times.
using Wave = std::vector<PlannedThrow>;

/// What a seed makes of wave `number` (from 1). Apexes lie in the upper third of the stage; fruit that is thrown at
/// once starts side by side where there is room. The same arguments give the same wave everywhere: only exactly rounded
/// operations. Cost O(throws^2).
Wave plan_wave(GameMode mode, int number, std::uint64_t seed);

/// How long frenzy waits between two throws, ticks.
inline constexpr sim::Tick kFrenzyGap = 18;

/// Throw `number` of a frenzy: from the left and from the right in turn, across the stage, no bombs.
PlannedThrow plan_frenzy_throw(std::uint64_t number, std::uint64_t seed);

}  // namespace kerf::game
