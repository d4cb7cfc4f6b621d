#include "viewer/app/inspect/inspection_window.h"

#include <iostream>
#include <utility>

#include "common/files/file_error.h"
#include "viewer/app/picture_name.h"
#include "viewer/app/run_report.h"
#include "viewer/game/stored_settings.h"
#include "viewer/game/user_folder.h"
#include "viewer/sim/camera.h"

namespace kerf::app {

namespace {

/// Runs of so many frames are compared with others; a game is not held up for it.
sim::Settings settings_for(const Options& options, sim::Settings settings)
{
    settings.hash_surfaces = options.frames > 0;
    return settings;
}

/// As loud as the game, where things break; a simulation that is only looked at is silent.
sound::Speaker speaker_for(const Options& options, const RunSetup& setup)
{
    if (setup.settings.scene != "shatter" || options.frames > 0) return sound::Speaker::silent();
    const game::StoredSettings stored = game::load_settings(game::user_folder()).settings;
    sound::Speaker speaker;
    speaker.set_volume(stored.volume);
    speaker.set_muted(stored.mute);
    return speaker;
}

}  // namespace

void FocusPause::follow(bool has_focus, sim::FrameClock& clock)
{
    if (had_focus_ && !has_focus && !clock.paused()) {
        clock.set_paused(true);
        has_paused_ = true;
    }
    if (has_focus && has_paused_) {
        clock.set_paused(false);
        has_paused_ = false;
    }
    had_focus_ = has_focus;
}

InspectionWindow::InspectionWindow(const Options& options, const RunSetup& setup, Window& window)
    : view_(options.view),
      window_(window),
      painter_(window.framebuffer_size().x, window.framebuffer_size().y),
      interface_(options.view.ui_scale * window.content_scale(), window.handle()),
      inspection_(setup, settings_for(options, setup.settings), options.autopilot, painter_),
      choices_(inspection_.simulation()),
      speaker_(speaker_for(options, setup)),
      messages_(setup.messages)
{
    window_.set_vsync(options.vsync);
    painter_.warm_up(*setup.models, inspection_.simulation().scene().most_pieces());
    for (std::string& message : painter_.take_messages()) messages_.push_back(std::move(message));
    if (!messages_.empty()) say(messages_.front());
    // Who watches a game wants to see the game, unless he asked for the panel.
    if (inspection_.game() != nullptr && !options.wants_panel) view_.panel = false;
}

void InspectionWindow::advance(const Frame& frame)
{
    if (frame.pace == Pace::real_time) focus_pause_.follow(window_.has_focus(), clock_);
    take_input();
    notice_.advance(frame.seconds);
    simulate(frame);
}

void InspectionWindow::take_input()
{
    for (const WindowKey& key : window_.take_keys())
        if (const auto action = action_of(key.code); action && key.is_down && !interface_.wants_keyboard())
            act(*action);
    const glm::dvec2 size(window_.size());
    if (size.x < 1.0 || size.y < 1.0) return;
    const sim::Camera camera(size.x / size.y);
    for (const WindowPointer& change : window_.take_pointer()) {
        const bool is_press = change.kind == WindowPointer::Kind::press;
        if (is_press && (interface_.wants_mouse() || clock_.paused())) continue;
        pointer_.push_back({kind_of(change.kind), camera.screen_to_stage(change.position, size)});
    }
}

void InspectionWindow::simulate(const Frame& frame)
{
    const bool is_fixed = frame.pace == Pace::fixed_step;
    const sim::Simulation& simulation = inspection_.simulation();
    if (frame.number > 0) inspection_.add_frame(1e3 * frame.seconds);
    clock_.set_time_scale(simulation.scene().time_scale());
    const sim::Tick ticks = is_fixed ? sim::kTicksPerFrame : clock_.advance(frame.seconds);
    std::vector<sim::InputEvent> events;
    if (ticks > 0) {
        const sim::Microseconds end = sim::time_of(simulation.now() + ticks);
        events = sampler_.frame(simulation.time(), end, std::exchange(pointer_, {}));
    }
    inspection_.advance(ticks, events, is_fixed);
    soundtrack_.follow(simulation, speaker_);
    if (std::string message = inspection_.simulation().take_message(); !message.empty()) {
        if (is_fixed) messages_.push_back(message);
        say(std::move(message));
    }
}

void InspectionWindow::draw(const Frame& frame, const glm::ivec2& size)
{
    painter_.resize(size.x, size.y);
    inspection_.paint(view_, inspection_.has_effects(), frame.pace == Pace::fixed_step ? 1.0 : clock_.fraction());
    PanelState state = inspection_.panel(view_, notice_.text());
    state.paused = clock_.paused();
    state.slow_motion = clock_.slow_motion();
    const glm::ivec2 units = window_.size();
    inspection_.use_letters(interface_, units);
    interface_.begin();
    inspection_.write(interface_, units, state);
    interface_.draw();
    for (const std::string& command : state.commands) inspection_.simulation().command(command);
}

void InspectionWindow::act(KeyAction action)
{
    switch (action) {
        case KeyAction::next_backend:
            return say(choices_.next_backend());
        case KeyAction::next_lookup:
            return say(choices_.next_lookup());
        case KeyAction::next_proxy:
            return say(choices_.next_proxy());
        case KeyAction::gesture:
            return say(choices_.next_gesture());
        case KeyAction::wireframe:
            view_.wireframe = !view_.wireframe;
            break;
        case KeyAction::proxies:
            view_.proxies = !view_.proxies;
            break;
        case KeyAction::lighting:
            view_.lighting =
                view_.lighting == render::Lighting::textured ? render::Lighting::lambert : render::Lighting::textured;
            break;
        case KeyAction::pause:
            clock_.set_paused(!clock_.paused());
            break;
        case KeyAction::single_step:
            clock_.step_once();
            break;
        case KeyAction::slow_motion:
            clock_.set_slow_motion(!clock_.slow_motion());
            break;
        case KeyAction::repeat_throw:
            simulation().command("repeat");
            break;
        case KeyAction::next_throw:
            simulation().command("throw");
            break;
        case KeyAction::panel:
            view_.panel = !view_.panel;
            break;
        case KeyAction::help:
            view_.help = !view_.help;
            break;
        case KeyAction::screenshot:
            save_picture();
            break;
        case KeyAction::fullscreen:
            window_.set_fullscreen(!window_.fullscreen());
            break;
        case KeyAction::vsync:
            window_.set_vsync(!window_.vsync());
            say(window_.vsync() ? "frames wait for the screen" : "frames do not wait for the screen");
            break;
        case KeyAction::quit:
            window_.close();
            break;
    }
}

/// Nobody loses a game over a full disk.
void InspectionWindow::save_picture()
{
    const std::filesystem::path path = new_picture_name();
    try {
        render::write_png(path, painter_.target().read());
        say("saved " + path.string());
    } catch (const core::io::FileError& error) {
        say(error.what());
    }
}

int run_inspection(const Options& options)
{
    const RunSetup setup = read_run_setup(options);
    for (const std::string& message : setup.messages) std::cerr << "kerf-viewer: " << message << "\n";
    Window window(options.width, options.height, options.fullscreen, "Kerf");
    render::GlErrorLog errors;
    InspectionWindow inspection(options, setup, window);
    WindowDisplay display(window);
    const Pace pace = options.frames > 0 ? Pace::fixed_step : Pace::real_time;
    MainLoop(inspection, display, errors, {pace, options.frames, 1, options.screenshot, options.record}).run();

    if (!options.save_script.empty()) sim::write_script(options.save_script, inspection.simulation().recording());
    const int status = finish_run(errors);
    if (options.frames > 0) {
        const render::FrameTarget& picture = inspection.picture();
        nlohmann::ordered_json report = report_head({picture.width(), picture.height()}, errors);
        report["messages"] = inspection.messages();
        report["runs"] = nlohmann::ordered_json::array({inspection.report()});
        std::cout << report.dump(2) << "\n";
    }
    return status;
}

}  // namespace kerf::app
