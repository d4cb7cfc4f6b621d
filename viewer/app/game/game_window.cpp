#include "viewer/app/game/game_window.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "common/files/file_error.h"
#include "viewer/app/picture_name.h"
#include "viewer/app/run_report.h"
#include "viewer/game/user_folder.h"

namespace kerf::app {

namespace {

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
    setup.seed =
        options.seed.value_or(static_cast<std::uint64_t>(std::chrono::steady_clock::now().time_since_epoch().count()));
    return setup;
}

}  // namespace

GameWindow::GameWindow(const Options& options, const std::filesystem::path& user_folder, Window& window)
    : view_(options.view),
      window_(window),
      painter_(window.framebuffer_size().x, window.framebuffer_size().y),
      interface_(1.0f),
      flow_(setup_of(options, user_folder), painter_, speaker_)
{
    // What the command line said about the window goes before what is stored.
    applied_ = flow_.settings();
    window_.set_vsync(options.vsync && applied_.vsync);
    if (!options.has_size && applied_.window_scale != 1.0) resize(applied_.window_scale);
    if (applied_.fullscreen) set_fullscreen(true);
    applied_ = flow_.settings();
}

void GameWindow::advance(const Frame& frame)
{
    pause_without_focus();
    take_input();
    follow_settings();
    flow_.advance(frame.seconds);
}

void GameWindow::pause_without_focus()
{
    const bool has_focus = window_.has_focus();
    if (had_focus_ && !has_focus) flow_.pause();
    had_focus_ = has_focus;
}

void GameWindow::draw(const Frame& frame, const glm::ivec2& size)
{
    painter_.resize(size.x, size.y);
    flow_.paint(view_);
    interface_.use_game_letters(size.x, size.y);
    interface_.begin(size.x, size.y, std::max(frame.seconds, 1e-4));
    ui::Canvas canvas(interface_.letters(), glm::vec2(size));
    flow_.write(canvas);
    interface_.draw();
}

void GameWindow::take_input()
{
    for (const WindowKey& key : window_.take_keys()) {
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
    } catch (const core::io::FileError& error) {
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
    Window window(options.width, options.height, options.fullscreen, "Kerf");
    render::GlErrorLog errors;
    GameWindow game(options, game::user_folder(), window);
    WindowDisplay display(window);
    MainLoop(game, display, errors, {}).run();
    return finish_run(errors);
}

}  // namespace kerf::app
