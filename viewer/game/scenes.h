#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/game/giant_scene.h"
#include "viewer/sim/model_library.h"
#include "viewer/sim/scene.h"

namespace kerf::game {

/// All scenes of the viewer: those of sim::scene_names() and the games.
const std::vector<std::string>& scene_names();

/// How a scene is to be played.
struct SceneOptions
{
    std::int64_t best = 0;  ///< score to beat, for games that count
    sim::Readiness readiness = sim::Readiness::at_once;
};

/// A scene to hand to sim::Simulation.
/// @param models  those of the simulation, with add_fruit_models() for the games
/// @throws std::invalid_argument  one sentence: an unknown name, a model is missing
std::unique_ptr<sim::Scene> make_scene(std::string_view name, const std::shared_ptr<sim::ModelLibrary>& models,
                                       const SceneOptions& options = {});

}  // namespace kerf::game
