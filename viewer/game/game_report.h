#pragma once

#include <nlohmann/json.hpp>

#include "viewer/game/game_scene.h"

namespace kerf::game {

/// Mode, result and all events, for a run's report.
nlohmann::ordered_json report_of(const GameScene& game);

std::string_view name_of(GamePhase phase);
std::string_view name_of(GameEnd end);

}  // namespace kerf::game
