#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/sim/model_shelf.h"
#include "viewer/sim/scene.h"

namespace kerf::game {

/// All scenes of the viewer: those of sim::scene_names() and the games.
const std::vector<std::string>& scene_names();

/// A scene to hand to sim::Simulation.
/// @param models  with add_fruit() for the games
/// @param best    score to beat, for games that count
/// @throws std::invalid_argument  one sentence: an unknown name, a model is missing
std::unique_ptr<sim::Scene> make_scene(std::string_view name, const sim::ModelShelf& models, std::int64_t best = 0);

}  // namespace kerf::game
