#include "viewer/game/game_events.h"

namespace kerf::game {

std::string_view name_of(GameEventKind kind)
{
    switch (kind) {
        case GameEventKind::wave:
            return "wave";
        case GameEventKind::thrown:
            return "thrown";
        case GameEventKind::fruit_cut:
            return "fruit_cut";
        case GameEventKind::critical:
            return "critical";
        case GameEventKind::combo:
            return "combo";
        case GameEventKind::missed:
            return "missed";
        case GameEventKind::life_lost:
            return "life_lost";
        case GameEventKind::extra_life:
            return "extra_life";
        case GameEventKind::bomb:
            return "bomb";
        case GameEventKind::special_started:
            return "special_started";
        case GameEventKind::special_ended:
            return "special_ended";
        case GameEventKind::game_over:
            return "game_over";
    }
    return "wave";
}

}  // namespace kerf::game
