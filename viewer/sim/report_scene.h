#pragma once

#include "viewer/sim/scene.h"
#include "viewer/sim/thrower.h"

namespace kerf::sim {

/// The report's program: the library's models thrown one at a time, the next when nothing of the last is left on stage.
/// Commands: `throw [MODEL]` throws now, `repeat` throws the last one again, exactly as it was.
class ReportScene : public Scene
{
public:
    std::string_view name() const override { return "report"; }
    void tick(Simulation& simulation) override;
    bool command(Simulation& simulation, std::string_view verb, std::string_view argument) override;
    std::vector<std::size_t> next_models() const override { return {next_model_}; }
    void hash(StateHash& hash) const override;

private:
    void throw_next(Simulation& simulation);

    std::size_t next_model_ = 0;
    std::uint64_t throws_ = 0;
};

}  // namespace kerf::sim
