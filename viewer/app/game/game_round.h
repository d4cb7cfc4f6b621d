#pragma once

#include "viewer/app/game/demo_blade.h"
#include "viewer/app/game/simulated_round.h"
#include "viewer/game/game_scene.h"

namespace kerf::app {

/// A game with rules and a score.
class GameRound : public SimulatedRound
{
public:
    /// @param setup          with a game::GameScene
    /// @param is_new_player  he is shown how to cut, until he does
    GameRound(RoundSetup setup, bool is_new_player, sound::Speaker& speaker);

    bool is_over() override;
    bool has_cut_fruit() const override { return state().counts.fruit_cut > 0; }
    std::optional<PlayedGame> take_score(bool is_left) override;
    void describe(ui::ScreenContent& content, ui::Screen screen) override;
    const sim::Blade* demo_blade() const override;

protected:
    void watch(const RoundFrame& frame) override;
    void write_display(ui::Canvas& canvas, const RoundText& text) override;

private:
    const game::GameScene& game() const { return *game::game_of(simulation()->scene()); }
    const game::GameState& state() const { return game().state(); }
    /// How to cut.
    bool teaches() const { return is_new_player_ && !has_cut_fruit(); }

    bool is_new_player_;
    DemoBlade demo_;
    std::optional<sim::Tick> over_at_;
    bool is_scored_ = false;
};

}  // namespace kerf::app
