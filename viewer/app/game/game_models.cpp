#include "viewer/app/game/game_models.h"

#include "viewer/app/game/stone_asteroid.h"
#include "viewer/game/fruit_models.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

namespace {

/// Triangles of what stands for the giant on the menu.
constexpr std::uint64_t kSmallAsteroid = 3000;

}  // namespace

GameModels::GameModels(const std::filesystem::path& data_folder)
{
    game::add_fruit_models(*library_, data_folder / "fruit");
    library_->add("asteroid", stone_asteroid(kSmallAsteroid, 3));
    fruit_ = library_->size();
}

void GameModels::look_ahead(const Round& round, bool waits)
{
    const sim::Simulation* const simulation = round.simulation();
    if (simulation == nullptr) return;
    preparer_.want(round.next_models(), simulation->backend(), simulation->proxy());
    if (waits) preparer_.finish();
}

}  // namespace kerf::app
