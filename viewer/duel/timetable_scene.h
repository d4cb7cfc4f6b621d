#pragma once

#include <vector>

#include "viewer/sim/scene.h"
#include "viewer/sim/thrower.h"
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
    /// A duel lasts so long; the last throws are early enough to be cut.
    static constexpr sim::Tick kLength = 60 * sim::kTicksPerSecond;
    static constexpr sim::Tick kLastThrow = kLength - 2 * sim::kTicksPerSecond;

    /// What is thrown.
    struct Item
    {
        std::size_t model = 0;  ///< index in the library
        double radius = sim::kThrownRadius;
    };

    /// @param items  thrown in turn; not empty
    explicit TimetableScene(std::vector<Item> items) : items_(std::move(items)) {}

    std::string_view name() const override { return "duel"; }
    void tick(sim::Simulation& simulation) override;
    void hash(sim::StateHash& hash) const override { hash.add(throws_); }

private:
    std::vector<Item> items_;
    std::uint64_t throws_ = 0;
};

}  // namespace kerf::duel
