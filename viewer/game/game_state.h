#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/game/fruit.h"
#include "viewer/game/game_mode.h"

namespace kerf::game {

enum class GamePhase : std::uint8_t
{
    playing,
    over,  ///< nothing counts any more; what flies falls down
};

/// The effect of a special fruit, while it lasts.
struct ActiveSpecial
{
    FruitKind kind = FruitKind::freeze;
    double seconds_left = 0.0;  ///< as the player counts them
    double share_left = 0.0;    ///< 1 at its start, 0 at its end
};

/// Why a game was over.
enum class GameEnd : std::uint8_t
{
    none,
    missed,  ///< no lives left
    bomb,
    time,
    given_up,
};

/// What has happened in a game so far, for its results.
struct GameCounts
{
    std::int64_t fruit_cut = 0, fruit_missed = 0, criticals = 0, combos = 0, bombs_cut = 0;
    int longest_combo = 0;  ///< fruit
};

/// All that a display shows of a game.
struct GameState
{
    GameMode mode = GameMode::classic;
    GamePhase phase = GamePhase::playing;
    GameEnd end = GameEnd::none;
    std::int64_t score = 0;
    std::int64_t best = 0;   ///< of this mode so far, this game included once it is better; 0: no game before
    bool is_best = false;    ///< this game has beaten the best of those before it
    int lives = 0;           ///< only where Rules::lives > 0
    int lives_at_start = 0;  ///< 0: this mode has none
    std::optional<double> seconds_left;  ///< empty: no end
    int combo = 0;                       ///< fruit that the swipe under way has cut so far
    int multiplier = 1;
    std::vector<ActiveSpecial> specials;
    int wave = 0;  ///< counts up from 1; 0 before the first
    GameCounts counts;
};

}  // namespace kerf::game
