#include "viewer/duel/timetable_scene.h"

#include "viewer/sim/simulation.h"

namespace kerf::duel {

void TimetableScene::tick(sim::Simulation& simulation)
{
    const sim::Tick since = simulation.now() - kGetReady;
    if (since < 0 || since % kInterval != 0 || simulation.now() > kLastThrow) return;
    const Item& item = items_[throws_ % items_.size()];
    simulation.throw_object({item.model, simulation.seed_for(throws_), item.radius});
    ++throws_;
}

}  // namespace kerf::duel
