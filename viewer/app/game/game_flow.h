#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/app/frame_statistics.h"
#include "viewer/app/game/duel_view.h"
#include "viewer/app/game/game_models.h"
#include "viewer/app/game/giant_controls.h"
#include "viewer/app/game/line_pointer.h"
#include "viewer/app/game/round.h"
#include "viewer/app/painter.h"
#include "viewer/app/view_settings.h"
#include "viewer/app/window.h"
#include "viewer/game/autopilot.h"
#include "viewer/game/high_scores.h"
#include "viewer/game/stored_settings.h"
#include "viewer/sound/speaker.h"
#include "viewer/ui/notice.h"
#include "viewer/ui/screen_view.h"

namespace kerf::app {

/// What the game begins with.
struct GameSetup
{
    std::filesystem::path data_folder;  ///< where `fruit/` lies
    std::filesystem::path user_folder;  ///< for scores and settings; empty: nothing is stored
    std::string scene = "menu";
    std::string backend;                     ///< empty: the stored one
    std::vector<std::string> duelists = {};  ///< back ends of a duel; as DuelView takes them
    sim::ProxyKind proxy = sim::ProxyKind::bounded_hull;
    std::uint64_t seed = 1;
    bool record = false;      ///< keep what is pushed, for Simulation::recording()
    bool fixed_step = false;  ///< every frame is two ticks, nothing depends on the time of day or on a thread's speed
    std::int64_t boulder = DuelView::kBoulder;  ///< triangles, of the duel
    std::int64_t giant = 0;                     ///< triangles, of the giant; 0: as stored
    bool fullscreen = false;                    ///< on the whole screen, whatever is stored
};

/// The game without a window: which round is played, which screen is shown over it, and what leads from one to another.
/// Whoever has a window hands in what the player does and shows the pictures.
class GameFlow
{
public:
    /// @throws core::io::FileError  the fruit cannot be read
    GameFlow(const GameSetup& setup, Painter& painter, sound::Speaker& speaker);
    /// A game under way counts as far as it got.
    ~GameFlow();
    GameFlow(const GameFlow&) = delete;
    GameFlow& operator=(const GameFlow&) = delete;

    /// From the moment the results are seen to the first press or key that chooses something on them: who still swipes,
    /// or cuts with Space, would throw them away unread.
    static constexpr double kResultsShown = 0.8;  ///< seconds: a swipe that is under way, and a glance

    // What the player does.

    void press(ui::MenuKey key);
    /// A key of the blade without a mouse; it means something while a game is played.
    void hold(ui::BladeKey key, bool is_down);
    /// A key of the scene `giant`: another back end, another giant.
    void next_backend();
    void next_giant();
    void toggle_mute();
    void set_fullscreen(bool on);
    /// Says something on the picture for some seconds.
    void tell(std::string message) { notice_.say(std::move(message)); }
    /// Begins the game anew that has just ended; otherwise nothing happens.
    void play_again();
    /// The player looks elsewhere.
    void pause();
    /// @param change  pixels of a picture of this size
    void point(const WindowPointer& change, const glm::vec2& size);
    /// Input of a script, for the round that is played now.
    void push(const std::vector<sim::InputEvent>& events) { round_->push(events); }
    /// Lets a player without hands swipe; before each advance(), with the same `autopilot`.
    void let_play(game::Autopilot& autopilot);
    /// Goes to another screen at once, for pictures.
    void show_screen(ui::Screen screen) { screens_.show(screen); }

    /// Time goes on by a frame. @param seconds  since the last one; in fixed steps only shown
    void advance(double seconds);

    /// Uploads what is new, without painting: for frames that nobody sees. @throws render::RenderError
    void sync() { round_->sync(painter_); }
    /// Paints the stage. @throws render::RenderError
    void paint(const ViewSettings& view);
    /// Writes over it, between UserInterface::begin() and draw().
    void write(ui::Canvas& canvas);

    bool has_ended() const { return has_ended_; }
    const ui::Screens& screens() const { return screens_; }
    const game::StoredSettings& settings() const { return screens_.settings(); }
    const std::string& scene() const { return round_->scene(); }
    const Round& round() const { return *round_; }
    /// Null during a duel.
    const sim::Simulation* simulation() const { return round_->simulation(); }
    /// Null at other times.
    DuelView* duel() { return round_->duel(); }
    GiantControls* giant() { return round_->giant(); }
    /// How far the giant is that is being made or uploaded, 0 to 1, never falling; empty when there is none.
    std::optional<double> giant_progress();
    const sim::ModelLibrary& models() const { return *models_.library(); }
    /// Where the lines of the screen are that was written last. Pixels.
    const std::vector<ui::Hotspot>& hotspots() const { return pointer_.lines(); }
    /// What is said now; empty: nothing.
    const std::string& message() const { return notice_.text(); }
    const game::HighScores& scores() const { return scores_; }

private:
    void start(const std::string& scene);
    std::unique_ptr<Round> make_round(const std::string& scene);
    std::unique_ptr<sim::Scene> make_scene(const std::string& scene);
    void follow_round();
    void carry_out(const ui::Request& request);
    void change_settings(const game::StoredSettings& changed);
    void apply_settings();
    void store_settings();
    void choose_giant(std::int64_t triangles);
    bool press_button(const glm::vec2& place);
    bool point_at_screen(const WindowPointer& change);
    Attention attention() const;
    void keep_score(bool is_left);
    std::vector<std::pair<std::string, std::vector<ui::ScoreLine>>> score_lists() const;

    GameSetup setup_;
    Painter& painter_;
    sound::Speaker& speaker_;
    GameModels models_;
    game::HighScores scores_;
    ui::Screens screens_;
    game::StoredSettings stored_;  ///< the settings as they are in their file
    LinePointer pointer_;
    ui::Notice notice_;
    FrameStatistics frames_;
    std::unique_ptr<Round> round_;
    std::optional<std::size_t> latest_place_;  ///< of this round's game among the scores
    bool is_new_player_ = true;
    double unread_ = 0.0;  ///< seconds for which the results take nothing but arrow keys
    bool has_ended_ = false;
};

}  // namespace kerf::app
