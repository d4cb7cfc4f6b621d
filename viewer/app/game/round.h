#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/game/blade_input.h"
#include "viewer/app/painter.h"
#include "viewer/app/view_settings.h"
#include "viewer/game/autopilot.h"
#include "viewer/game/high_scores.h"
#include "viewer/sim/frame_clock.h"
#include "viewer/ui/screen_view.h"

namespace kerf::app {

class DuelView;
class GiantControls;

/// What the player may do to a round in a frame.
enum class Attention
{
    played,   ///< it goes on, and he cuts
    watched,  ///< it goes on behind a menu
    held,     ///< it stands still
};

/// A frame of a round.
struct RoundFrame
{
    double seconds = 0.0;  ///< since the last one; without meaning in fixed steps
    glm::vec2 size{1.0f};  ///< of the picture, pixels
    Attention attention = Attention::played;
    std::optional<std::size_t> mode = {};  ///< that the menu has selected; empty: another screen is shown
};

/// What is written over a round's picture besides its own.
struct RoundText
{
    ui::Screen screen = ui::Screen::play;
    bool has_message = false;             ///< it stands where a hint would be
    glm::vec2 pointer{-1.0f};             ///< on the picture
    std::optional<double> arriving = {};  ///< of what is on its way to the graphics card: GpuWorld::arriving()
};

/// A game that is to be kept among the scores.
struct PlayedGame
{
    game::GameMode mode = game::GameMode::classic;
    game::HighScore score;
};

/// Everything that lives as long as one game, one duel or one visit to the menu: it is built anew for each.
class Round
{
public:
    virtual ~Round() = default;
    Round(const Round&) = delete;
    Round& operator=(const Round&) = delete;

    const std::string& scene() const { return scene_; }
    /// Ticks since its beginning.
    virtual sim::Tick now() const = 0;
    /// A frame goes by.
    void advance(const RoundFrame& frame);

    // Input.

    void hold(ui::BladeKey key, bool is_down) { blade_input_.hold(key, is_down); }
    virtual void point(const WindowPointer& change, const glm::vec2& size) { blade_input_.point(change, size); }
    /// Of a script.
    virtual void push(const std::vector<sim::InputEvent>& events) = 0;
    /// Lets a player without hands swipe; before each advance().
    virtual void let_play(game::Autopilot& autopilot) = 0;
    /// A game of the menu was chosen by its line: cuts the fruit that stands for it.
    virtual void choose(const std::string& /*scene*/) {}
    const BladeInput& blade_input() const { return blade_input_; }

    // What comes of it.

    /// The game that was chosen on the menu, as soon as it is to begin; empty: none.
    virtual std::string chosen() const { return {}; }
    /// It has ended, and what came of it is to be shown.
    virtual bool is_over() { return false; }
    /// The player has cut a fruit: nobody need show him how.
    virtual bool has_cut_fruit() const { return false; }
    /// Once: when the game is over, or when it is left. @param is_left  it is left now
    virtual std::optional<PlayedGame> take_score(bool /*is_left*/) { return std::nullopt; }
    /// What is to be said to the player; empty: nothing.
    virtual std::string take_message() { return {}; }

    // The picture.

    /// Uploads what is new. @throws render::RenderError
    virtual void sync(Painter& painter) = 0;
    /// Paints what sync() has uploaded. @throws render::RenderError
    virtual void paint(Painter& painter, const ViewSettings& view) = 0;
    void write(ui::Canvas& canvas, const RoundText& text);
    /// Adds what a screen shows of this round.
    virtual void describe(ui::ScreenContent& /*content*/, ui::Screen /*screen*/) {}

    // What some rounds have; null: this one has none.

    virtual const sim::Simulation* simulation() const { return nullptr; }
    virtual DuelView* duel() { return nullptr; }
    virtual GiantControls* giant() { return nullptr; }
    /// The blade that shows how to cut.
    virtual const sim::Blade* demo_blade() const { return nullptr; }
    /// Models that will be thrown next, the first of them first.
    virtual std::vector<std::size_t> next_models() const { return {}; }

protected:
    /// @param fixed_step  every frame is two ticks, whatever the time
    Round(std::string scene, bool fixed_step, const StageLayout& layout)
        : scene_(std::move(scene)), fixed_step_(fixed_step), blade_input_(layout)
    {
    }

    virtual double time_scale() const { return 1.0; }
    /// So many ticks more, with their input.
    virtual void go_on(sim::Tick ticks, const std::vector<sim::InputEvent>& events, const RoundFrame& frame) = 0;
    /// The player holds the game.
    virtual void let_go() { blade_input_.let_go(); }
    virtual void write_stage(ui::Canvas& canvas, const RoundText& text) = 0;

    bool fixed_step() const { return fixed_step_; }
    /// Of the tick that is under way.
    double fraction() const { return fixed_step_ ? 1.0 : clock_.fraction(); }

private:
    std::string scene_;
    bool fixed_step_;
    BladeInput blade_input_;
    sim::FrameClock clock_;
};

}  // namespace kerf::app
