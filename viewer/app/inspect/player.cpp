#include "viewer/app/inspect/player.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "common/cpu_stopwatch.h"
#include "common/stopwatch.h"
#include "viewer/app/exit_status.h"
#include "viewer/app/inspect/game_overlay.h"
#include "viewer/app/inspect/panel.h"
#include "viewer/app/picture_name.h"
#include "viewer/render/offscreen_context.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/camera.h"
#include "viewer/sim/proxy_names.h"

namespace kerf::app {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kMessageTime{6};

/// Runs of so many frames are compared with others; a game is not held up for it.
sim::Settings settings_for(const Options& options, sim::Settings settings)
{
    settings.hash_surfaces = options.frames > 0;
    return settings;
}

bool is_baseline(const std::string& backend)
{
    return backend.starts_with("baseline");
}

/// The element after `current`, round and round.
template <typename Range, typename Value>
auto next_of(const Range& range, const Value& current)
{
    auto found = std::find(std::begin(range), std::end(range), current);
    if (found != std::end(range)) ++found;
    return found == std::end(range) ? *std::begin(range) : *found;
}

}  // namespace

Player::Player(const Options& options, const Session& session)
    : options_(options),
      window_(options.width, options.height, options.fullscreen, "Kerf"),
      painter_(window_.framebuffer_size().x, window_.framebuffer_size().y),
      interface_(options.view.ui_scale * window_.content_scale(), window_.handle()),
      simulation_(session.models, settings_for(options, session.settings), session.make_scene()),
      preparer_(session.models),
      autopilot_(session.settings.seed),
      messages_(session.messages)
{
    window_.set_vsync(options.vsync);
    painter_.warm_up(*session.models);
    for (std::string& message : painter_.take_messages()) messages_.push_back(std::move(message));
    if (!options.record.empty()) recording_.emplace(options.record);
    simulation_.push(session.script.events);
    if (!messages_.empty()) say(messages_.front());
    // Who watches a game wants to see the game, unless he asked for the panel.
    if (game::game_of(simulation_.scene()) != nullptr && !options.wants_panel) options_.view.panel = false;
}

bool Player::frame()
{
    window_.poll();
    if (window_.should_close()) return false;
    pause_without_focus();
    take_input();
    simulate();
    if (const glm::ivec2 size = window_.framebuffer_size(); size.x > 0 && size.y > 0) show();
    errors_.check();
    ++frame_;
    const bool is_last = fixed_step() && frame_ >= options_.frames;
    if (is_last && !options_.screenshot.empty()) save_picture(options_.screenshot);
    return !is_last;
}

void Player::pause_without_focus()
{
    const bool has_focus = window_.has_focus();
    if (!fixed_step() && had_focus_ && !has_focus && !clock_.paused()) {
        clock_.set_paused(true);
        paused_by_focus_ = true;
    }
    if (has_focus && paused_by_focus_) {
        clock_.set_paused(false);
        paused_by_focus_ = false;
    }
    had_focus_ = has_focus;
}

void Player::take_input()
{
    for (const KeyAction action : window_.take_keys())
        if (!interface_.wants_keyboard()) act(action);
    const glm::dvec2 size(window_.size());
    if (size.x < 1.0 || size.y < 1.0) return;
    const sim::Camera camera(size.x / size.y);
    for (const WindowPointer& change : window_.take_pointer()) {
        using Kind = sim::PointerChange::Kind;
        const bool is_press = change.kind == WindowPointer::Kind::press;
        if (is_press && (interface_.wants_mouse() || clock_.paused())) continue;
        const Kind kind = is_press                                   ? Kind::press
                          : change.kind == WindowPointer::Kind::move ? Kind::move
                                                                     : Kind::release;
        pointer_.push_back({kind, camera.screen_to_stage(change.position, size)});
    }
}

void Player::simulate()
{
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - std::exchange(last_frame_, now)).count();
    if (frame_ > 0) statistics_.add(1e3 * seconds);
    clock_.set_time_scale(simulation_.scene().time_scale());
    const sim::Tick ticks = fixed_step() ? sim::kTicksPerFrame : clock_.advance(seconds);
    preparer_.want(simulation_.scene().next_models(), simulation_.backend(), simulation_.proxy());
    if (fixed_step()) preparer_.finish();
    const double checks = simulation_.check_cpu_ms();
    CpuStopwatch watch;
    if (ticks > 0) {
        if (options_.autopilot) simulation_.push(autopilot_.play(simulation_));
        const sim::Microseconds end = sim::time_of(simulation_.now() + ticks);
        simulation_.push(sampler_.frame(simulation_.time(), end, pointer_));
        pointer_.clear();
        simulation_.advance(ticks);
    }
    simulate_cpu_ms_ = 1e3 * watch.lap() - (simulation_.check_cpu_ms() - checks);
    times_.simulate_cpu_ms.push_back(simulate_cpu_ms_);
    if (std::string message = simulation_.take_message(); !message.empty()) {
        if (fixed_step()) messages_.push_back(message);
        say(std::move(message));
    }
}

void Player::show()
{
    Stopwatch whole;
    CpuStopwatch submit;
    const glm::ivec2 pixels = window_.framebuffer_size();
    painter_.resize(pixels.x, pixels.y);
    painter_.sync(simulation_);
    const game::GameScene* const game = game::game_of(simulation_.scene());
    if (game != nullptr) effects_.follow(simulation_);
    painter_.paint(simulation_, options_.view, fixed_step() ? 1.0 : clock_.fraction(),
                   game != nullptr ? &effects_ : nullptr);
    times_.submit_cpu_ms.push_back(1e3 * submit.lap());

    if (Clock::now() > message_until_) message_.clear();
    PanelState state{simulation_, painter_, statistics_, options_.view, message_};
    state.simulation_ms = simulate_cpu_ms_;
    state.paused = clock_.paused();
    state.slow_motion = clock_.slow_motion();
    const glm::ivec2 units = window_.size();
    if (game != nullptr) interface_.use_game_letters(units.x, units.y);
    interface_.begin();
    show_panel(state);
    if (game != nullptr) show_game(interface_, units.x, units.y, *game, effects_);
    interface_.draw();
    for (const std::string& command : state.commands) simulation_.command(command);

    if (recording_) recording_->add(painter_.target().read());
    painter_.target().show(pixels.x, pixels.y);
    window_.swap();
    times_.frame_ms.push_back(whole.lap());
}

void Player::act(KeyAction action)
{
    switch (action) {
        case KeyAction::next_backend:
            switch_backend();
            break;
        case KeyAction::next_lookup:
            switch_lookup();
            break;
        case KeyAction::next_proxy:
            switch_proxy();
            break;
        case KeyAction::wireframe:
            options_.view.wireframe = !options_.view.wireframe;
            break;
        case KeyAction::proxies:
            options_.view.proxies = !options_.view.proxies;
            break;
        case KeyAction::lighting:
            options_.view.lighting = options_.view.lighting == render::Lighting::textured ? render::Lighting::lambert
                                                                                          : render::Lighting::textured;
            break;
        case KeyAction::gesture:
            switch_gesture();
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
            simulation_.command("repeat");
            break;
        case KeyAction::next_throw:
            simulation_.command("throw");
            break;
        case KeyAction::panel:
            options_.view.panel = !options_.view.panel;
            break;
        case KeyAction::help:
            options_.view.help = !options_.view.help;
            break;
        case KeyAction::screenshot:
            save_picture(new_picture_name());
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

void Player::switch_backend()
{
    const std::string current = simulation_.backend_to_come();
    if (is_baseline(current)) last_baseline_ = current;
    const auto& names = sim::backend_names();
    const auto other = std::find_if(names.begin(), names.end(), [](const auto& name) { return !is_baseline(name); });
    const std::string wanted = !is_baseline(current) || other == names.end() ? last_baseline_ : *other;
    simulation_.command("backend " + wanted);
    say("the next throw is cut by " + sim::find_backend(wanted));
}

void Player::switch_lookup()
{
    std::vector<std::string> lookups;
    for (const std::string& name : sim::backend_names())
        if (is_baseline(name)) lookups.push_back(name);
    const std::string wanted = next_of(lookups, simulation_.backend_to_come());
    simulation_.command("backend " + wanted);
    say("the next throw is cut by " + wanted);
}

void Player::switch_proxy()
{
    const std::string wanted(name_of(next_of(sim::kProxyKinds, simulation_.proxy_to_come())));
    simulation_.command("proxy " + wanted);
    say("the next throw collides as " + wanted);
}

void Player::switch_gesture()
{
    const bool to_segment = simulation_.gesture_to_come() == sim::Gesture::blade;
    const sim::Gesture wanted = to_segment ? sim::Gesture::segment : sim::Gesture::blade;
    simulation_.command("gesture " + std::string(name_of(wanted)));
    say(to_segment ? "cuts on release, along the straight line" : "cuts while moving");
}

void Player::say(std::string message)
{
    message_ = std::move(message);
    message_until_ = Clock::now() + kMessageTime;
}

void Player::save_picture(const std::filesystem::path& path)
{
    try {
        render::write_png(path, painter_.target().read());
        say("saved " + path.string());
    } catch (const io::FileError& error) {
        // Nobody loses a game over a full disk.
        if (fixed_step()) throw;
        say(error.what());
    }
}

int run_player(const Options& options)
{
    const Session session = open_session(options);
    for (const std::string& message : session.messages) std::cerr << "kerf-viewer: " << message << "\n";
    Player player(options, session);
    while (player.frame()) {
    }
    if (!options.save_script.empty()) sim::write_script(options.save_script, player.simulation().recording());
    const render::GlErrorLog& errors = player.errors();
    for (const std::string& message : errors.messages()) std::cerr << "kerf-viewer: GL: " << message << "\n";
    if (options.frames > 0) {
        const nlohmann::ordered_json report{{"version", KERF_VERSION},
                                            {"graphics", render::describe_current_context()},
                                            {"width", player.painter().target().width()},
                                            {"height", player.painter().target().height()},
                                            {"gl_errors", errors.count()},
                                            {"gl_messages", errors.messages()},
                                            {"messages", player.messages()},
                                            {"runs", nlohmann::ordered_json::array({player.report()})}};
        std::cout << report.dump(2) << "\n";
    }
    return errors.count() == 0 ? kDone : kUnusable;
}

}  // namespace kerf::app
