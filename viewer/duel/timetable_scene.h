#pragma once

#include <vector>

#include "viewer/sim/scene.h"
#include "viewer/sim/ticks.h"

namespace kerf::duel {

/// Throws by the clock, whatever became of what was thrown before: two simulations with the same seed throw the same at
/// the same ticks, even after their pieces have parted company. The scene of a duel.
class TimetableScene : public sim::Scene
{
public:
    /// From one throw to the next.
    static constexpr sim::Tick kInterval = 168;  // 1.4 s
    /// Before the first.
    static constexpr sim::Tick kGetReady = 120;

    /// @param models  indices on the shelf, thrown in turn; not empty
    explicit TimetableScene(std::vector<std::size_t> models) : models_(std::move(models)) {}

    std::string_view name() const override { return "duel"; }
    void tick(sim::Simulation& simulation) override;
    void hash(sim::StateHash& hash) const override { hash.add(throws_); }

private:
    std::vector<std::size_t> models_;
    std::uint64_t throws_ = 0;
};

}  // namespace kerf::duel
