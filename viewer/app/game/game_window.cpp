#include "viewer/app/game/game_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <iostream>

#include "common/io/mesh_file.h"
#include "viewer/app/exit_status.h"
#include "viewer/app/picture_name.h"
#include "viewer/game/user_folder.h"
#include "viewer/sim/back_ends.h"

namespace kerf::app {

namespace {

using Clock = std::chrono::steady_clock;

GameSetup setup_of(const Options& options, const std::filesystem::path& user_folder)
{
    GameSetup setup;
    setup.data_folder = options.data_folder;
    setup.user_folder = user_folder;
    if (!options.scene.empty()) setup.scene = options.scene;
    if (!options.backends.empty()) setup.backend = options.backends.front();
    if (setup.scene == "duel") setup.duelists = options.backends;
    setup.giant = options.giant;
    setup.fullscreen = options.fullscreen;
    if (options.boulder > 0) setup.boulder = options.boulder;
    // Another game each time, unless somebody wants this one.
    setup.seed = options.seed.value_or(static_cast<std::uint64_t>(Clock::now().time_since_epoch().count()));
    return setup;
}

}  // namespace

GameWindow::GameWindow(const Options& options, const std::filesystem::path& user_folder)
    : options_(options),
      window_(options.width, options.height, options.fullscreen, "Kerf"),
      painter_(window_.framebuffer_size().x, window_.framebuffer_size().y),
      interface_(1.0f),
      flow_(setup_of(options, user_folder), painter_, speaker_)
{
    window_.set_vsync(options.vsync);
    // What the command line said about the window goes before what is stored.
    applied_ = flow_.settings();
    if (options.vsync) window_.set_vsync(applied_.vsync);
    if (!options.has_size && applied_.window_scale != 1.0) resize(applied_.window_scale);
    if (applied_.fullscreen) set_fullscreen(true);
    applied_ = flow_.settings();
}

bool GameWindow::frame()
{
    window_.poll();
    if (window_.should_close() || flow_.has_ended()) return false;
    const bool has_focus = window_.has_focus();
    if (had_focus_ && !has_focus) flow_.pause();
    had_focus_ = has_focus;
    take_input();
    follow_settings();
    const Clock::time_point now = Clock::now();
    const double seconds = std::chrono::duration<double>(now - std::exchange(last_frame_, now)).count();
    flow_.advance(seconds);

    if (const glm::ivec2 pixels = window_.framebuffer_size(); pixels.x > 0 && pixels.y > 0) {
        painter_.resize(pixels.x, pixels.y);
        flow_.paint(options_.view);
        interface_.use_game_letters(pixels.x, pixels.y);
        interface_.begin(pixels.x, pixels.y, std::max(seconds, 1e-4));
        ui::Canvas canvas(interface_.letters(), glm::vec2(pixels));
        flow_.write(canvas);
        interface_.draw();
        painter_.target().show(pixels.x, pixels.y);
        window_.swap();
    }
    errors_.check();
    return true;
}

void GameWindow::take_input()
{
    window_.take_keys();  // they mean something in the viewer of models only
    for (const WindowKey& key : window_.take_key_codes()) {
        steer(key);
        if (key.is_down) take_key(key.code);
    }
    const glm::dvec2 size(window_.size()), pixels(window_.framebuffer_size());
    if (size.x < 1.0 || size.y < 1.0) return;
    for (WindowPointer change : window_.take_pointer()) {
        change.position *= pixels / size;
        flow_.point(change, glm::vec2(pixels));
    }
}

void GameWindow::steer(const WindowKey& key)
{
    // By their places: on any keyboard these four lie together.
    switch (key.code) {
        case GLFW_KEY_W:
            return flow_.hold(ui::BladeKey::up, key.is_down);
        case GLFW_KEY_S:
            return flow_.hold(ui::BladeKey::down, key.is_down);
        case GLFW_KEY_A:
            return flow_.hold(ui::BladeKey::left, key.is_down);
        case GLFW_KEY_D:
            return flow_.hold(ui::BladeKey::right, key.is_down);
        case GLFW_KEY_SPACE:
            return flow_.hold(ui::BladeKey::cut, key.is_down);
        default:
            return;
    }
}

void GameWindow::take_key(int key)
{
    switch (key) {
        case GLFW_KEY_UP:
            return flow_.press(ui::MenuKey::up);
        case GLFW_KEY_DOWN:
            return flow_.press(ui::MenuKey::down);
        case GLFW_KEY_LEFT:
            return flow_.press(ui::MenuKey::left);
        case GLFW_KEY_RIGHT:
            return flow_.press(ui::MenuKey::right);
        case GLFW_KEY_ENTER:
        case GLFW_KEY_KP_ENTER:
        case GLFW_KEY_SPACE:
            return flow_.press(ui::MenuKey::accept);
        case GLFW_KEY_ESCAPE:
        case GLFW_KEY_P:
            return flow_.press(ui::MenuKey::back);
        case GLFW_KEY_M:
            return flow_.toggle_mute();
        case GLFW_KEY_B:
            return flow_.next_backend();
        case GLFW_KEY_N:
            return flow_.next_giant();
        case GLFW_KEY_R:
            return flow_.play_again();
        case GLFW_KEY_F11:
            return flow_.set_fullscreen(!flow_.settings().fullscreen);
        case GLFW_KEY_F12:
            return save_picture();
        default:
            return;
    }
}

void GameWindow::save_picture()
{
    const std::filesystem::path name = new_picture_name();
    std::error_code ignored;
    try {
        render::write_png(name, painter_.target().read());
        flow_.tell("Saved " + std::filesystem::absolute(name, ignored).string());
    } catch (const io::FileError& error) {
        flow_.tell(error.what());
    }
}

void GameWindow::follow_settings()
{
    const game::StoredSettings wanted = flow_.settings();
    if (wanted.vsync != applied_.vsync) window_.set_vsync(wanted.vsync);
    if (wanted.window_scale != applied_.window_scale) resize(wanted.window_scale);
    if (wanted.fullscreen != applied_.fullscreen) set_fullscreen(wanted.fullscreen);
    applied_ = flow_.settings();
}

/// Where there is no whole screen to be had, the settings say so.
void GameWindow::set_fullscreen(bool on)
{
    window_.set_fullscreen(on);
    if (window_.fullscreen() != on) flow_.set_fullscreen(window_.fullscreen());
}

void GameWindow::resize(double scale)
{
    window_.resize(static_cast<int>(std::lround(1280.0 * scale)), static_cast<int>(std::lround(720.0 * scale)));
}

int run_game(const Options& options)
{
    GameWindow game(options, game::user_folder());
    while (game.frame()) {
    }
    const render::GlErrorLog& errors = game.errors();
    for (const std::string& message : errors.messages()) std::cerr << "kerf-viewer: GL: " << message << "\n";
    return errors.count() == 0 ? kDone : kUnusable;
}

}  // namespace kerf::app
