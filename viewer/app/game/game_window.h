#pragma once

#include <chrono>

#include "viewer/app/game/game_flow.h"
#include "viewer/app/options.h"
#include "viewer/app/user_interface.h"
#include "viewer/app/window.h"
#include "viewer/render/gl_error_log.h"

namespace kerf::app {

/// The game in a window, in real time.
class GameWindow
{
public:
    /// @param user_folder  for scores and settings; empty: nothing is stored
    /// @throws render::NoDisplay, render::RenderError, io::FileError
    GameWindow(const Options& options, const std::filesystem::path& user_folder);

    /// One frame. False when it was the last. @throws render::RenderError
    bool frame();

    GameFlow& flow() { return flow_; }
    Window& window() { return window_; }
    render::GlErrorLog& errors() { return errors_; }

private:
    void take_input();
    void take_key(int key);
    void steer(const WindowKey& key);
    void follow_settings();
    void set_fullscreen(bool on);
    void resize(double scale);
    void save_picture();

    Options options_;
    Window window_;
    render::GlErrorLog errors_;
    Painter painter_;
    UserInterface interface_;
    sound::Speaker speaker_;
    GameFlow flow_;
    game::StoredSettings applied_;  ///< to the window
    bool had_focus_ = false;
    std::chrono::steady_clock::time_point last_frame_ = std::chrono::steady_clock::now();
};

/// Opens the window and plays until it is closed. Gives the exit status.
/// @throws render::RenderError, io::FileError
int run_game(const Options& options);

}  // namespace kerf::app
