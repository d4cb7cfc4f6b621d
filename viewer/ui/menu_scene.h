#pragma once

#include <array>
#include <optional>
#include <vector>

#include "viewer/sim/scene.h"

namespace kerf::ui {

/// The menu's stage: a fruit for each of modes() hangs in the air and turns; the one that is cut is chosen. Models that
/// are not in the library are left out.
class MenuScene : public sim::Scene
{
public:
    std::string_view name() const override { return "menu"; }
    double gravity() const override { return 0.0; }
    void tick(sim::Simulation& simulation) override;
    void on_cut(sim::Simulation& simulation, const sim::CutRecord& cut) override;
    void hash(sim::StateHash& hash) const override;

    /// Index into modes(); empty before anything was cut.
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// When it was.

private:
    bool placed_ = false;
    std::vector<sim::ObjectId> objects_;  ///< whole, in the order of modes(); 0: none
    std::optional<std::size_t> chosen_;
};

}  // namespace kerf::ui
