#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/app/frame_statistics.h"
#include "viewer/app/game/cut_times.h"
#include "viewer/app/game/duel_show.h"
#include "viewer/app/game/soundtrack.h"
#include "viewer/app/painter.h"
#include "viewer/app/view_settings.h"
#include "viewer/app/window.h"
#include "viewer/effects/effects.h"
#include "viewer/game/autopilot.h"
#include "viewer/game/user_files.h"
#include "viewer/sim/frame_clock.h"
#include "viewer/sim/model_preparer.h"
#include "viewer/sim/pointer_sampler.h"
#include "viewer/sound/speaker.h"
#include "viewer/ui/keyboard_blade.h"
#include "viewer/ui/notice.h"
#include "viewer/ui/screen_view.h"

namespace kerf::app {

/// What a show begins with.
struct ShowSetup
{
    std::filesystem::path data_folder;  ///< where `fruit/` lies
    std::filesystem::path user_folder;  ///< for scores and settings; empty: nothing is stored
    std::string scene = "menu";
    std::string backend;                     ///< empty: the stored one
    std::vector<std::string> duelists = {};  ///< back ends of a duel; as DuelShow takes them
    ProxyKind proxy = ProxyKind::bounded_hull;
    std::uint64_t seed = 1;
    bool record = false;      ///< keep what is pushed, for Simulation::recording()
    bool fixed_step = false;  ///< every frame is two ticks, nothing depends on the time of day or on a thread's speed
    std::int64_t boulder = DuelShow::kBoulder;  ///< triangles, of the duel
    std::int64_t giant = 0;                     ///< triangles, of the giant; 0: as stored
    bool fullscreen = false;                    ///< on the whole screen, whatever is stored
};

/// The game: menu, modes, duel, pause, settings and scores, without a window. Whoever has one hands in what the player
/// does and shows the pictures.
class GameShow
{
public:
    /// @throws io::FileError  the fruit cannot be read
    GameShow(const ShowSetup& setup, Painter& painter, sound::Speaker& speaker);
    /// A game under way counts as far as it got.
    ~GameShow();
    GameShow(const GameShow&) = delete;
    GameShow& operator=(const GameShow&) = delete;

    /// From the moment the balance is seen to the first press or key that chooses something on it: who still swipes, or
    /// cuts with Space, would throw it away unread.
    static constexpr double kBalanceShown = 0.8;  ///< seconds: a swipe that is under way, and a glance

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
    void tell(std::string message);
    /// Begins the game anew that has just ended; otherwise nothing happens.
    void play_again();
    /// The player looks elsewhere.
    void pause();
    /// @param change  pixels of a picture of this size
    void point(const WindowPointer& change, const glm::vec2& size);
    /// Input of a script, for the scene that is played now.
    void push(const std::vector<sim::InputEvent>& events);
    /// Lets a player without hands swipe; before each advance(), with the same `autopilot`. In a duel it looks at one
    /// half and at the other in turn, and its swipes go to both like anybody's.
    void let_play(game::Autopilot& autopilot);
    /// Goes to another screen at once, for pictures.
    void show_screen(ui::Screen screen);

    /// Time goes on by a frame. @param seconds  since the last one; without meaning in fixed steps
    void advance(double seconds);

    /// Uploads what is new, without painting: for frames that nobody sees. @throws render::RenderError
    void sync();
    /// Paints the stage. @throws render::RenderError
    void paint(const ViewSettings& view);
    /// Writes over it, between UserInterface::begin() and draw().
    void write(ui::Canvas& canvas);

    bool has_ended() const { return has_ended_; }
    const ui::Screens& screens() const { return screens_; }
    const game::StoredSettings& settings() const { return screens_.settings(); }
    const std::string& scene() const { return scene_; }
    /// Null during a duel.
    const sim::Simulation* simulation() const { return simulation_.get(); }
    DuelShow* duel() { return duel_.get(); }
    const ui::KeyboardBlade& keyboard_blade() const { return keyboard_blade_; }
    const effects::Effects& effects() const { return effects_; }
    /// That shows who has cut nothing yet how it is done.
    const sim::Blade& demo_blade() const { return demo_; }
    /// How far the giant is that is being made or uploaded, 0 to 1, never falling; empty when there is none.
    std::optional<double> giant_progress() const;
    const sim::ModelLibrary& models() const { return *models_; }
    /// Of the giant, for each back end.
    const CutTimes& cut_times() const { return cut_times_; }
    /// Where the lines of the screen are that was written last, and the buttons of the giant. Pixels.
    const std::vector<ui::Hotspot>& hotspots() const { return hotspots_; }
    const std::array<ui::Box2, 2>& giant_buttons() const { return giant_buttons_; }
    /// What is said now; empty: nothing.
    const std::string& message() const { return notice_.text(); }
    const game::UserFiles& files() const { return files_; }

private:
    void start(const std::string& scene);
    void carry_out(const ui::Request& request);
    void choose_mode(const std::string& scene);
    void store_settings();
    bool is_held() const;
    void let_go();
    void look_ahead();
    void simulate(sim::Tick ticks);
    void watch_menu();
    void watch_game();
    void watch_duel();
    void show_balance();
    std::optional<ui::Pointed> line_at(const glm::vec2& place) const;
    void move_demo_blade();
    void show_first_cut(const game::GameScene& played);
    void move_keyboard_blade(double seconds);
    void write_cross(ui::Canvas& canvas) const;
    bool press_button(const glm::vec2& place);
    void write_giant(ui::Canvas& canvas);
    void set_giant(double share);
    void keep_score();
    std::vector<std::pair<std::string, std::vector<ui::ScoreLine>>> score_lists() const;

    ShowSetup setup_;
    Painter& painter_;
    sound::Speaker& speaker_;
    std::shared_ptr<sim::ModelLibrary> models_ = std::make_shared<sim::ModelLibrary>();
    sim::ModelPreparer preparer_{models_};
    std::size_t fruit_models_ = 0;  ///< the first ones in the library: what the menu and the games show
    game::UserFiles files_;
    ui::Screens screens_;
    game::StoredSettings stored_;  ///< the settings as they are on disk, or soon will be
    std::string scene_;
    std::uint64_t games_ = 0;

    std::unique_ptr<sim::Simulation> simulation_;
    std::unique_ptr<DuelShow> duel_;
    effects::Effects effects_;
    Soundtrack soundtrack_;
    sim::FrameClock clock_;
    sim::PointerSampler sampler_;
    std::vector<sim::PointerChange> pointer_;
    ui::KeyboardBlade keyboard_blade_;
    std::vector<sim::InputEvent> script_;  ///< for the duel: not yet due
    bool swiping_ = false;
    std::size_t pressed_half_ = 0;        ///< of a duel: where the swipe began, and where its places are read
    std::optional<std::size_t> sliding_;  ///< the line whose slider is being moved
    /// The screen as Screens counts them, and the line on it that is chosen when the button is let go there.
    std::optional<std::pair<std::uint64_t, std::size_t>> pressed_;
    double unread_ = 0.0;  ///< seconds for which the balance takes nothing but arrow keys
    double fraction_ = 1.0;

    std::string wanted_;  ///< the mode that was chosen by key, while its fruit is being cut
    sim::Tick wanted_at_ = 0;
    std::optional<sim::Tick> over_at_;
    std::optional<std::size_t> latest_place_;  ///< of the last game among the scores
    sim::Blade demo_;                          ///< shows on the menu and in the first game how to cut
    sim::ObjectId demo_fruit_ = 0;             ///< that it went through last
    sim::Tick demo_start_ = 0;
    sim::Tick touched_at_ = -1000;  ///< when the player last swiped
    bool is_new_player_ = true;
    FrameStatistics frames_;
    CutTimes cut_times_;
    double giant_share_ = 0.0;  ///< of its slider
    ui::Box2 giant_slider_;
    std::array<ui::Box2, 2> giant_buttons_;  ///< another back end, another giant
    bool giant_sliding_ = false;
    std::vector<ui::Hotspot> hotspots_;
    std::uint64_t hotspots_of_ = 0;  ///< the screen they belong to, as Screens counts them
    glm::vec2 pointed_at_{-1.0f};    ///< of the picture
    ui::Notice notice_;
    bool has_ended_ = false;
};

}  // namespace kerf::app
