#pragma once

#include <optional>
#include <string>
#include <vector>

#include "viewer/app/frame_statistics.h"
#include "viewer/app/inspect/panel.h"
#include "viewer/app/inspect/simulation_report.h"
#include "viewer/app/painter.h"
#include "viewer/app/run_setup.h"
#include "viewer/app/user_interface.h"
#include "viewer/effects/effects.h"
#include "viewer/game/autopilot.h"
#include "viewer/game/shatter_scene.h"
#include "viewer/sim/model_preparer.h"

namespace kerf::app {

/// One simulation that is looked at: its ticks, its pictures, and what both cost. It knows no window.
class Inspection
{
public:
    /// @param settings      in place of those of `setup`
    /// @param is_autopilot  the program swipes
    /// @param painter       outlives it
    Inspection(const RunSetup& setup, const sim::Settings& settings, bool is_autopilot, Painter& painter);

    /// So many ticks with their input.
    /// @param waits  for what a thread makes ready ahead, so that a run is the same on every machine
    void advance(sim::Tick ticks, const std::vector<sim::InputEvent>& events, bool waits);
    /// Uploads what is new. @throws render::RenderError
    void sync() { painter_.sync(simulation_); }
    /// Uploads what is new and paints the stage.
    /// @param shows_effects  drops and stains
    /// @param fraction       of the tick that is under way
    /// @throws render::RenderError
    void paint(const ViewSettings& view, bool shows_effects, double fraction = 1.0);

    /// Loads the letters that write() needs. Before UserInterface::begin().
    void use_letters(UserInterface& interface, const glm::ivec2& size) const;
    /// The panel, and what is written over a game, in a picture of this size. Between begin() and draw().
    void write(const UserInterface& interface, const glm::ivec2& size, PanelState& state) const;
    /// What the panel shows of this simulation.
    PanelState panel(ViewSettings& view, std::string message);

    /// A frame of so long: for the panel.
    void add_frame(double ms) { statistics_.add(ms); }
    /// From the beginning of a frame to its finished picture: for the report.
    void add_frame_time(double ms) { times_.frame_ms.push_back(ms); }

    sim::Simulation& simulation() { return simulation_; }
    const sim::Simulation& simulation() const { return simulation_; }
    /// Null: it is no game.
    const game::GameScene* game() const { return game::game_of(simulation_.scene()); }
    /// Whether drops and dust belong to it.
    bool has_effects() const { return game() != nullptr || game::shatter_of(simulation_.scene()) != nullptr; }
    /// Of the run so far.
    nlohmann::ordered_json report() const { return report_of(simulation_, painter_.world(), times_); }

private:
    Painter& painter_;
    sim::Simulation simulation_;
    sim::ModelPreparer preparer_;
    std::optional<game::Autopilot> autopilot_;
    effects::Effects effects_;
    FrameStatistics statistics_;
    FrameTimes times_;
};

}  // namespace kerf::app
