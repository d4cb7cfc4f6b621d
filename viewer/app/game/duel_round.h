#pragma once

#include "viewer/app/game/duel_view.h"
#include "viewer/app/game/round.h"

namespace kerf::app {

/// What a duel is begun with.
struct DuelSetup
{
    std::shared_ptr<sim::ModelLibrary> models;  ///< with the fruit
    sim::Settings settings;
    std::int64_t boulder = DuelView::kBoulder;  ///< triangles of what is thrown between the fruit
    std::vector<std::string> backends = {};     ///< as DuelView takes them
    bool fixed_step = false;                    ///< preparing is waited for
};

/// A duel of two back ends.
class DuelRound : public Round
{
public:
    explicit DuelRound(const DuelSetup& setup);

    sim::Tick now() const override { return view_.now(); }
    void push(const std::vector<sim::InputEvent>& events) override;
    /// Looks at one half and at the other in turn; the swipes go to both like anybody's.
    void let_play(game::Autopilot& autopilot) override;
    bool is_over() override { return view_.is_over(); }
    void sync(Painter& painter) override { view_.sync(painter); }
    void paint(Painter& painter, const ViewSettings& view) override;
    void describe(ui::ScreenContent& content, ui::Screen screen) override;
    DuelView* duel() override { return &view_; }

protected:
    void go_on(sim::Tick ticks, const std::vector<sim::InputEvent>& events, const RoundFrame& frame) override;
    void write_stage(ui::Canvas& canvas, const RoundText& text) override;

private:
    DuelView view_;
    std::vector<sim::InputEvent> script_;  ///< not yet due
};

}  // namespace kerf::app
