#include "viewer/app/game/simulated_round.h"

#include <utility>

#include "viewer/ui/hud.h"

namespace kerf::app {

SimulatedRound::SimulatedRound(RoundSetup setup, sound::Speaker& speaker)
    : Round(setup.settings.scene, setup.fixed_step, StageLayout()),
      simulation_(std::move(setup.models), setup.settings, std::move(setup.scene)),
      speaker_(speaker)
{
}

double SimulatedRound::time_scale() const
{
    return effects_.time_scale() * simulation_.scene().time_scale();
}

void SimulatedRound::go_on(sim::Tick ticks, const std::vector<sim::InputEvent>& events, const RoundFrame& frame)
{
    simulation_.push(events);
    simulation_.advance(ticks);
    effects_.follow(simulation_);
    soundtrack_.follow(simulation_, speaker_);
    watch(frame);
}

/// Nothing hisses while the game stands still.
void SimulatedRound::let_go()
{
    Round::let_go();
    speaker_.set_fuse(false);
}

void SimulatedRound::paint(Painter& painter, const ViewSettings& view)
{
    painter.paint(simulation_, view, fraction(), &effects_, simulation_.blade().pressed() ? nullptr : demo_blade());
}

void SimulatedRound::write_stage(ui::Canvas& canvas, const RoundText& text)
{
    ui::show_effects(canvas, effects_, {{0.0f, 0.0f}, canvas.size()});
    write_display(canvas, text);
}

}  // namespace kerf::app
