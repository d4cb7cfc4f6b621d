#pragma once

#include <cstddef>

#include "viewer/game/game_scene.h"
#include "viewer/sim/blade.h"
#include "viewer/sim/simulation.h"

namespace kerf::app {

/// A blade that shows how one cuts, and cuts nothing. Called after each batch of ticks, it moves when it is time.
class DemoBlade
{
public:
    /// Now and then across the fruit of the menu that stands for a mode. @param mode  index into ui::modes()
    void show_on_menu(const sim::Simulation& simulation, std::size_t mode);
    /// Through a fruit that is near its apex, one after another.
    void show_in_game(const sim::Simulation& simulation, const game::GameScene& played);

    const sim::Blade& blade() const { return blade_; }
    /// Nothing is to be seen of it.
    bool is_away(const sim::Simulation& simulation) const { return blade_.trail(simulation.time()).empty(); }

private:
    const sim::Body* next_fruit(const sim::Simulation& simulation, const game::GameScene& played);

    sim::Blade blade_;
    sim::ObjectId fruit_ = 0;  ///< that it went through last
    sim::Tick start_ = 0;      ///< when it began to
};

}  // namespace kerf::app
