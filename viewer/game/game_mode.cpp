#include "viewer/game/game_mode.h"

namespace kerf::game {

std::string_view name_of(GameMode mode)
{
    switch (mode) {
        case GameMode::classic:
            return "classic";
        case GameMode::arcade:
            return "arcade";
        case GameMode::zen:
            return "zen";
    }
    return "classic";
}

std::optional<GameMode> find_mode(std::string_view name)
{
    for (const GameMode mode : kGameModes)
        if (name_of(mode) == name) return mode;
    return std::nullopt;
}

const Rules& rules_of(GameMode mode)
{
    static constexpr Rules kClassic{kFirstLives, 0, true, kPointsPerLife};
    static constexpr Rules kArcade{0, 60 * sim::kTicksPerSecond, false, 0};
    static constexpr Rules kZen{0, 90 * sim::kTicksPerSecond, false, 0};
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

}  // namespace kerf::game
