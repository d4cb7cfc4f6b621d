#include "viewer/sim/report_scene.h"

#include "viewer/sim/simulation.h"

namespace kerf::sim {

void ReportScene::tick(Simulation& simulation)
{
    if (simulation.bodies().empty()) throw_next(simulation);
}

void ReportScene::throw_next(Simulation& simulation)
{
    const std::size_t model = next_model_;
    next_model_ = (next_model_ + 1) % simulation.models().size();
    simulation.throw_object({model, simulation.seed_for(throws_++)});
}

bool ReportScene::command(Simulation& simulation, std::string_view verb, std::string_view argument)
{
    if (verb == "repeat") {
        if (simulation.last_throw()) simulation.throw_object(*simulation.last_throw());
        return true;
    }
    if (verb != "throw") return false;
    if (!argument.empty()) {
        const ModelLibrary& models = simulation.models();
        std::size_t wanted = 0;
        while (wanted < models.size() && models.model(wanted).name != argument) ++wanted;
        if (wanted == models.size()) {
            simulation.report("there is no model '" + std::string(argument) + "'");
            return true;
        }
        next_model_ = wanted;
    }
    throw_next(simulation);
    return true;
}

void ReportScene::hash(StateHash& hash) const
{
    hash.add(std::uint64_t(next_model_));
    hash.add(throws_);
}

}  // namespace kerf::sim
