#pragma once

#include <string>
#include <vector>

#include "viewer/app/inspect/inspection.h"
#include "viewer/app/inspect/keys.h"
#include "viewer/app/inspect/throw_choices.h"
#include "viewer/app/main_loop.h"
#include "viewer/app/options.h"
#include "viewer/app/soundtrack.h"
#include "viewer/app/window.h"
#include "viewer/sim/frame_clock.h"
#include "viewer/sim/pointer_sampler.h"
#include "viewer/ui/notice.h"

namespace kerf::app {

/// A clock that stands still while the window does not have the focus, unless it did already.
class FocusPause
{
public:
    void follow(bool has_focus, sim::FrameClock& clock);

private:
    bool has_paused_ = false, had_focus_ = false;
};

/// A simulation to look at in a window. Objects fly in real time; in fixed steps a script gives the same state as
/// without a window.
class InspectionWindow : public Program
{
public:
    /// @param window  outlives it
    /// @throws render::RenderError
    InspectionWindow(const Options& options, const RunSetup& setup, Window& window);

    void advance(const Frame& frame) override;
    void sync() override { inspection_.sync(); }
    void draw(const Frame& frame, const glm::ivec2& size) override;
    void take_frame_time(double ms) override { inspection_.add_frame_time(ms); }
    const render::FrameTarget& picture() const override { return painter_.target(); }

    /// What a key does; the window's keys come here.
    void act(KeyAction action);

    sim::Simulation& simulation() { return inspection_.simulation(); }
    bool paused() const { return clock_.paused(); }
    bool slow_motion() const { return clock_.slow_motion(); }
    const ViewSettings& view() const { return view_; }
    /// What is said to the user now.
    const std::string& message() const { return notice_.text(); }
    /// Everything that was said about models and commands that can't be used.
    const std::vector<std::string>& messages() const { return messages_; }
    /// Of the run so far.
    nlohmann::ordered_json report() const { return inspection_.report(); }

private:
    void take_input();
    void simulate(const Frame& frame);
    void save_picture();
    void say(std::string message) { notice_.say(std::move(message)); }

    ViewSettings view_;
    Window& window_;
    Painter painter_;
    UserInterface interface_;
    Inspection inspection_;
    ThrowChoices choices_;
    sound::Speaker speaker_;  ///< silent, but where things break
    Soundtrack soundtrack_;
    sim::FrameClock clock_;
    FocusPause focus_pause_;
    sim::PointerSampler sampler_;
    std::vector<sim::PointerChange> pointer_;  ///< since the last tick
    ui::Notice notice_;
    std::vector<std::string> messages_;
};

/// Opens the window and plays until it is closed, or for so many frames; then a report goes to standard output. Gives
/// the exit status.
/// @throws render::RenderError, core::io::FileError, std::invalid_argument
int run_inspection(const Options& options);

}  // namespace kerf::app
