#pragma once

#include "viewer/app/game/game_flow.h"
#include "viewer/app/main_loop.h"
#include "viewer/app/options.h"
#include "viewer/app/user_interface.h"
#include "viewer/app/window.h"

namespace kerf::app {

/// The game in a window.
class GameWindow : public Program
{
public:
    /// @param user_folder  for scores and settings; empty: nothing is stored
    /// @param window       outlives it
    /// @throws render::RenderError, core::io::FileError
    GameWindow(const Options& options, const std::filesystem::path& user_folder, Window& window);

    bool has_ended() const override { return flow_.has_ended(); }
    void advance(const Frame& frame) override;
    void sync() override { flow_.sync(); }
    void draw(const Frame& frame, const glm::ivec2& size) override;
    const render::FrameTarget& picture() const override { return painter_.target(); }

    GameFlow& flow() { return flow_; }

private:
    void pause_without_focus();
    void take_input();
    void take_key(int key);
    void steer(const WindowKey& key);
    void follow_settings();
    void set_fullscreen(bool on);
    void resize(double scale);
    void save_picture();

    ViewSettings view_;
    Window& window_;
    Painter painter_;
    UserInterface interface_;
    sound::Speaker speaker_;
    GameFlow flow_;
    game::StoredSettings applied_;  ///< to the window
    bool had_focus_ = false;
};

/// Opens the window and plays until it is closed. Gives the exit status.
/// @throws render::RenderError, core::io::FileError
int run_game(const Options& options);

}  // namespace kerf::app
