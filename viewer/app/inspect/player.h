#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "viewer/app/frame_statistics.h"
#include "viewer/app/inspect/run_report.h"
#include "viewer/app/options.h"
#include "viewer/app/painter.h"
#include "viewer/app/session.h"
#include "viewer/app/user_interface.h"
#include "viewer/app/window.h"
#include "viewer/effects/effects.h"
#include "viewer/game/autopilot.h"
#include "viewer/render/gl_error_log.h"
#include "viewer/sim/frame_clock.h"
#include "viewer/sim/model_preparer.h"
#include "viewer/sim/pointer_sampler.h"

namespace kerf::app {

/// The viewer in a window. Objects fly in real time; with Options::frames each frame is two ticks instead, so that a
/// script gives the same state as without a window.
class Player
{
public:
    /// @throws render::RenderError  no display
    Player(const Options& options, const Session& session);

    /// One frame: input, ticks, picture. False when it was the last.
    /// @throws render::RenderError, io::FileError
    bool frame();

    Window& window() { return window_; }
    sim::Simulation& simulation() { return simulation_; }
    const Painter& painter() const { return painter_; }
    render::GlErrorLog& errors() { return errors_; }
    bool paused() const { return clock_.paused(); }
    bool slow_motion() const { return clock_.slow_motion(); }
    const ViewSettings& view() const { return options_.view; }
    /// What is said to the user now.
    const std::string& message() const { return message_; }

    /// Everything that was said about models and commands that can't be used.
    const std::vector<std::string>& messages() const { return messages_; }

    /// What a key does; the window's keys come here.
    void act(KeyAction action);

    /// Of the run so far.
    nlohmann::ordered_json report() const { return report_of(simulation_, painter_.world(), times_); }

private:
    void take_input();
    void pause_without_focus();
    void simulate();
    void show();
    void say(std::string message);
    void switch_backend();
    void switch_lookup();
    void switch_proxy();
    void switch_gesture();
    void save_picture(const std::filesystem::path& path);
    bool fixed_step() const { return options_.frames > 0; }

    Options options_;
    Window window_;
    render::GlErrorLog errors_;
    Painter painter_;
    UserInterface interface_;
    sim::Simulation simulation_;
    sim::ModelPreparer preparer_;
    sim::FrameClock clock_;
    sim::PointerSampler sampler_;
    std::vector<sim::PointerChange> pointer_;  ///< since the last tick
    game::Autopilot autopilot_;
    std::optional<render::Recording> recording_;
    effects::Effects effects_;  ///< of a game
    FrameStatistics statistics_;
    FrameTimes times_;
    std::string last_baseline_ = "baseline";
    std::vector<std::string> messages_;
    std::string message_;
    std::chrono::steady_clock::time_point message_until_{};
    std::chrono::steady_clock::time_point last_frame_ = std::chrono::steady_clock::now();
    std::int64_t frame_ = 0;
    bool paused_by_focus_ = false, had_focus_ = false;
    double simulate_cpu_ms_ = 0.0;
};

/// Opens the window and plays until it is closed.
/// @throws render::RenderError, io::FileError, std::invalid_argument
int run_player(const Options& options);

}  // namespace kerf::app
