#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "viewer/app/frame_statistics.h"
#include "viewer/app/game/cut_times.h"
#include "viewer/app/window.h"
#include "viewer/game/giant_scene.h"
#include "viewer/sim/simulation.h"
#include "viewer/ui/canvas.h"

namespace kerf::app {

/// The panel of the scene `giant`: how large the giant is, what a frame and a cut take, and the buttons for another
/// size, another back end and another giant.
class GiantControls
{
public:
    /// @param simulation  of the scene `giant`; outlives it
    /// @param frames      how long frames took; outlives it
    GiantControls(sim::Simulation& simulation, const FrameStatistics& frames);

    /// Takes in what was cut since the last call.
    void follow() { cut_times_.follow(simulation_.cuts()); }

    void next_backend();
    void next_giant() { simulation_.command("next"); }
    /// Another size. @param share  of the slider, 0 to 1. Gives the triangles that were asked for.
    std::int64_t choose(double share);
    /// As a key does: along the slider by so much.
    std::int64_t step(double change) { return choose(share_ + change); }
    /// Presses the button at this place of the picture. False: there is none.
    bool press_button(const glm::vec2& place);
    /// The pointer on the slider. @param may_begin  a press takes hold of it
    /// False: it has nothing to do with this. When the button is let go the size is chosen: choose(share()).
    bool drag(const WindowPointer& change, bool may_begin);
    /// The slider is let go where it is.
    void let_go() { is_sliding_ = false; }
    double share() const { return share_; }

    /// How far the giant is that is being made or uploaded, 0 to 1, never falling; empty when there is none.
    /// @param arriving  GpuWorld::arriving()
    std::optional<double> progress(std::optional<double> arriving) const;
    /// @param pointer  its place on the picture
    void write(ui::Canvas& canvas, const glm::vec2& pointer, std::optional<double> arriving);

    /// What cuts took, for each back end.
    const CutTimes& cut_times() const { return cut_times_; }
    /// Another back end, another giant: where they were written last. Pixels.
    const std::array<ui::Box2, 2>& buttons() const { return buttons_; }

private:
    const game::GiantScene& giant() const { return *game::giant_of(simulation_.scene()); }
    void write_panel(ui::Canvas& canvas, const glm::vec2& pointer);
    void write_buttons(ui::Canvas& canvas, const ui::Box2& row, const glm::vec2& pointer);
    void write_progress(ui::Canvas& canvas, double progress) const;

    sim::Simulation& simulation_;
    const FrameStatistics& frames_;
    CutTimes cut_times_;
    double share_ = 0.0;  ///< of the slider
    ui::Box2 slider_;
    std::array<ui::Box2, 2> buttons_;
    bool is_sliding_ = false;
};

}  // namespace kerf::app
