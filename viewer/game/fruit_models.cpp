#include "viewer/game/fruit_models.h"

#include "viewer/game/fruit.h"

namespace kerf::game {

void add_fruit_models(sim::ModelLibrary& models, const std::filesystem::path& folder)
{
    for (const Fruit& fruit : fruit_catalogue()) models.add_file(folder / (std::string(fruit.model) + ".glb"));
}

}  // namespace kerf::game
