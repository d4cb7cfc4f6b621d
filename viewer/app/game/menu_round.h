#pragma once

#include "viewer/app/game/demo_blade.h"
#include "viewer/app/game/simulated_round.h"
#include "viewer/ui/menu_scene.h"

namespace kerf::app {

/// The menu's stage: the fruit that is cut chooses its game.
class MenuRound : public SimulatedRound
{
public:
    /// @param setup  without a scene: the menu's is made here
    /// @param fruit_models  so many models of the library, the first ones, are made ready: whatever game is chosen
    MenuRound(RoundSetup setup, std::size_t fruit_models, sound::Speaker& speaker);

    void point(const WindowPointer& change, const glm::vec2& size) override;
    void choose(const std::string& scene) override;
    std::string chosen() const override;
    std::vector<std::size_t> next_models() const override;
    const sim::Blade* demo_blade() const override;

protected:
    void watch(const RoundFrame& frame) override;

private:
    const ui::MenuScene& menu() const { return static_cast<const ui::MenuScene&>(simulation()->scene()); }

    std::size_t fruit_models_;
    DemoBlade demo_;
    std::string wanted_;  ///< the game that was chosen, while its fruit is being cut
    sim::Tick wanted_at_ = 0;
    sim::Tick touched_at_ = -1000;  ///< when the player last swiped
};

}  // namespace kerf::app
