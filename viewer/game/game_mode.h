#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "viewer/sim/ticks.h"
#include "viewer/sim/world.h"

namespace kerf::game {

enum class GameMode : std::uint8_t
{
    classic,  ///< three misses or a bomb end it
    arcade,   ///< a minute, with bombs that cost points and special fruit
    zen,      ///< a minute and a half in peace
};
inline constexpr std::array<GameMode, 3> kGameModes{GameMode::classic, GameMode::arcade, GameMode::zen};

/// Also the name of its scene.
std::string_view name_of(GameMode mode);
std::optional<GameMode> find_mode(std::string_view name);

/// Games are faster than nature: what is thrown is back in less than two seconds.
inline constexpr double kGameGravity = 2.0 * sim::kGravity;

/// Before the first wave.
inline constexpr sim::Tick kGetReady = sim::kTicksPerSecond;

/// A swipe that cuts so many fruit is a combo, and earns a point for each of them.
inline constexpr int kSmallestCombo = 3;
/// A swipe that goes on for ever is no trick: two fruit of a combo are cut within this time.
inline constexpr sim::Tick kComboGap = 36;  // 300 ms

/// A fruit is cut critically when the lighter side of the cut has at least this share of its mass. On an apple the
/// blade may pass 5 cm beside the centre, four pixels of 1280x720.
inline constexpr double kCriticalShare = 0.44;
inline constexpr int kCriticalPoints = 5;

inline constexpr int kFirstLives = 3, kMostLives = 5;
inline constexpr std::int64_t kPointsPerLife = 100;
inline constexpr int kBombCost = 10;

/// How long the effects of special fruit last, in ticks. Frozen time runs slower, so freezing lasts five seconds for
/// the player.
inline constexpr double kFrozenTimeScale = 0.4;
inline constexpr sim::Tick kFreezeTicks = 240, kFrenzyTicks = 600, kDoubleTicks = 960, kHammerTicks = 720;
inline constexpr int kDoubleMultiplier = 2;

/// What a mode is about.
struct Rules
{
    int lives = 0;                 ///< 0: misses cost nothing
    sim::Tick duration = 0;        ///< 0: no end
    bool bomb_ends = false;        ///< otherwise it costs kBombCost, but never more than there is
    std::int64_t life_points = 0;  ///< points that earn another life; 0: none
};
const Rules& rules_of(GameMode mode);

}  // namespace kerf::game
