#include "viewer/app/inspect/inspection.h"

#include <utility>

#include "common/support/cpu_stopwatch.h"
#include "viewer/app/inspect/game_overlay.h"

namespace kerf::app {

Inspection::Inspection(const RunSetup& setup, const sim::Settings& settings, bool is_autopilot, Painter& painter)
    : painter_(painter), simulation_(setup.models, settings, setup.make_scene()), preparer_(setup.models)
{
    if (is_autopilot) autopilot_.emplace(settings.seed);
    simulation_.push(setup.script.events);
}

void Inspection::advance(sim::Tick ticks, const std::vector<sim::InputEvent>& events, bool waits)
{
    preparer_.want(simulation_.scene().next_models(), simulation_.backend(), simulation_.proxy());
    if (waits) preparer_.finish();
    const double checks = simulation_.check_cpu_ms();
    core::CpuStopwatch watch;
    if (ticks > 0) {
        if (autopilot_) simulation_.push(autopilot_->play(simulation_));
        simulation_.push(events);
        simulation_.advance(ticks);
    }
    times_.simulate_cpu_ms.push_back(1e3 * watch.lap() - (simulation_.check_cpu_ms() - checks));
    effects_.follow(simulation_);
}

void Inspection::paint(const ViewSettings& view, bool shows_effects, double fraction)
{
    core::CpuStopwatch submit;
    sync();
    painter_.paint(simulation_, view, fraction, shows_effects ? &effects_ : nullptr);
    times_.submit_cpu_ms.push_back(1e3 * submit.lap());
}

void Inspection::use_letters(UserInterface& interface, const glm::ivec2& size) const
{
    if (game() != nullptr) interface.use_game_letters(size.x, size.y);
}

void Inspection::write(const UserInterface& interface, const glm::ivec2& size, PanelState& state) const
{
    show_panel(state);
    if (game() != nullptr) show_game(interface, size.x, size.y, *game(), effects_);
}

PanelState Inspection::panel(ViewSettings& view, std::string message)
{
    PanelState state{simulation_, painter_, statistics_, view, std::move(message)};
    if (!times_.simulate_cpu_ms.empty()) state.simulation_ms = times_.simulate_cpu_ms.back();
    return state;
}

}  // namespace kerf::app
