#include "viewer/game/scenes.h"

#include <stdexcept>

#include "viewer/game/game_scene.h"
#include "viewer/game/giant_scene.h"
#include "viewer/game/shatter_scene.h"

namespace kerf::game {

const std::vector<std::string>& scene_names()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all = sim::scene_names();
        for (const GameMode mode : kGameModes) all.emplace_back(name_of(mode));
        all.emplace_back("giant");
        all.emplace_back("shatter");
        return all;
    }();
    return names;
}

std::unique_ptr<sim::Scene> make_scene(std::string_view name, const std::shared_ptr<sim::ModelLibrary>& models,
                                       const SceneOptions& options)
{
    if (const std::optional<GameMode> mode = find_mode(name))
        return std::make_unique<GameScene>(*mode, *models, options.best);
    if (name == "giant") return std::make_unique<GiantScene>(models, options.readiness);
    if (name == "shatter") return std::make_unique<ShatterScene>();
    std::unique_ptr<sim::Scene> scene = sim::make_scene(name);
    if (!scene) throw std::invalid_argument("there is no scene '" + std::string(name) + "'");
    return scene;
}

}  // namespace kerf::game
