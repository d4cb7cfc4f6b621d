#include "viewer/duel/timetable_scene.h"

#include "viewer/sim/simulation.h"

namespace kerf::duel {

void TimetableScene::tick(sim::Simulation& simulation)
{
    const sim::Tick since = simulation.now() - kGetReady;
    if (since < 0 || since % kInterval != 0) return;
    simulation.throw_object({models_[throws_ % models_.size()], simulation.seed_for(throws_)});
    ++throws_;
}

}  // namespace kerf::duel
