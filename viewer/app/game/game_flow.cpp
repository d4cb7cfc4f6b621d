#include "viewer/app/game/game_flow.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "viewer/app/game/duel_round.h"
#include "viewer/app/game/game_round.h"
#include "viewer/app/game/giant_round.h"
#include "viewer/app/game/menu_round.h"
#include "viewer/game/scenes.h"
#include "viewer/game/stored_settings.h"
#include "viewer/sim/back_ends.h"

namespace kerf::app {

namespace {

game::StoredSettings settings_for(const GameSetup& setup, std::string& message)
{
    game::LoadedSettings loaded = game::load_settings(setup.user_folder);
    message = std::move(loaded.message);
    if (!setup.backend.empty()) loaded.settings.backend = setup.backend;
    if (setup.fullscreen) loaded.settings.fullscreen = true;
    return loaded.settings;
}

}  // namespace

GameFlow::GameFlow(const GameSetup& setup, Painter& painter, sound::Speaker& speaker)
    : setup_(setup),
      painter_(painter),
      speaker_(speaker),
      models_(setup.data_folder),
      scores_(setup.user_folder),
      screens_({}, sim::backend_names())
{
    std::string message;
    screens_.set_settings(settings_for(setup, message));
    stored_ = settings();
    tell(std::move(message));
    start(setup.scene);
}

GameFlow::~GameFlow()
{
    keep_score(true);
    store_settings();
}

void GameFlow::start(const std::string& scene)
{
    keep_score(true);
    if (scene == "menu")
        screens_.show(ui::Screen::menu);
    else
        screens_.play(scene);
    apply_settings();
    store_settings();
    round_.reset();
    painter_.forget_world();
    pointer_.forget_press();
    unread_ = 0.0;
    latest_place_.reset();
    speaker_.set_fuse(false);
    round_ = make_round(scene);
    if (!round_) return start("menu");
    if (scene != "menu" && scene != "duel") speaker_.play(sound::Sound::start);
}

/// Null: there is no such scene.
std::unique_ptr<Round> GameFlow::make_round(const std::string& scene)
{
    sim::Settings how;
    how.scene = scene;
    how.backend = settings().backend;
    how.proxy = setup_.proxy;
    how.seed = setup_.seed++;  // another game each time
    how.record = setup_.record;
    how.breaks = setup_.fixed_step ? sim::Readiness::at_once : sim::Readiness::when_ready;
    if (scene == "duel")
        return std::make_unique<DuelRound>(
            DuelSetup{models_.library(), how, setup_.boulder, setup_.duelists, setup_.fixed_step});

    RoundSetup setup{models_.library(), how, nullptr, setup_.fixed_step};
    if (scene == "menu") return std::make_unique<MenuRound>(std::move(setup), models_.fruit(), speaker_);
    setup.scene = make_scene(scene);
    if (!setup.scene) return nullptr;
    if (scene == "giant")
        return std::make_unique<GiantRound>(std::move(setup), setup_.giant > 0 ? setup_.giant : settings().giant,
                                            frames_, speaker_);
    if (game::game_of(*setup.scene) != nullptr)
        return std::make_unique<GameRound>(std::move(setup), is_new_player_, speaker_);
    return std::make_unique<SimulatedRound>(std::move(setup), speaker_);
}

/// Null, and the player is told why: there is no such scene.
std::unique_ptr<sim::Scene> GameFlow::make_scene(const std::string& scene)
{
    const std::optional<game::GameMode> mode = game::find_mode(scene);
    const sim::Readiness readiness = setup_.fixed_step ? sim::Readiness::at_once : sim::Readiness::when_ready;
    try {
        return game::make_scene(scene, models_.library(), {mode ? scores_.best(*mode) : 0, readiness});
    } catch (const std::invalid_argument& error) {
        tell(error.what());
        return nullptr;
    }
}

void GameFlow::carry_out(const ui::Request& request)
{
    using Kind = ui::Request::Kind;
    speaker_.play(sound::Sound::click);
    switch (request.kind) {
        case Kind::start:
            round_->choose(request.scene);
            break;
        case Kind::restart:
            start(request.scene);
            break;
        case Kind::resume:
            break;
        case Kind::to_menu:
            start("menu");
            break;
        case Kind::quit:
            has_ended_ = true;
            break;
        case Kind::settings:
            apply_settings();
            break;
    }
}

void GameFlow::change_settings(const game::StoredSettings& changed)
{
    screens_.set_settings(changed);
    apply_settings();
}

void GameFlow::apply_settings()
{
    speaker_.set_volume(settings().volume);
    speaker_.set_muted(settings().mute);
}

/// Takes milliseconds: not while a game is played or a slider is moved.
void GameFlow::store_settings()
{
    if (settings() == stored_) return;
    stored_ = settings();
    notice_.say_next(game::save_settings(setup_.user_folder, stored_));
}

void GameFlow::toggle_mute()
{
    game::StoredSettings changed = settings();
    changed.mute = !changed.mute;
    change_settings(changed);
    tell(changed.mute ? "Sound off" : "Sound on");
}

void GameFlow::set_fullscreen(bool on)
{
    game::StoredSettings changed = settings();
    changed.fullscreen = on;
    change_settings(changed);
}

void GameFlow::choose_giant(std::int64_t triangles)
{
    game::StoredSettings changed = settings();
    changed.giant = triangles;
    change_settings(changed);
}

void GameFlow::next_backend()
{
    if (giant() != nullptr) giant()->next_backend();
}

void GameFlow::next_giant()
{
    if (giant() != nullptr) giant()->next_giant();
}

void GameFlow::press(ui::MenuKey key)
{
    using ui::MenuKey;
    if (screens_.screen() == ui::Screen::play && (key == MenuKey::left || key == MenuKey::right)) {
        constexpr double kStep = 0.1;
        if (giant() != nullptr) choose_giant(giant()->step(key == MenuKey::left ? -kStep : kStep));
        return;
    }
    if (unread_ > 0.0 && (key == MenuKey::accept || key == MenuKey::back)) return;
    if (const std::optional<ui::Request> request = screens_.press(key)) carry_out(*request);
}

void GameFlow::hold(ui::BladeKey key, bool is_down)
{
    if (!is_down || screens_.screen() == ui::Screen::play) round_->hold(key, is_down);
}

void GameFlow::play_again()
{
    if (screens_.screen() != ui::Screen::over || unread_ > 0.0) return;
    if (const std::optional<ui::Request> request = screens_.click(0)) carry_out(*request);
}

void GameFlow::pause()
{
    if (screens_.screen() == ui::Screen::play) screens_.show(ui::Screen::paused);
}

void GameFlow::point(const WindowPointer& change, const glm::vec2& size)
{
    using Kind = WindowPointer::Kind;
    const glm::vec2 place(change.position);
    const bool is_press = change.kind == Kind::press, is_played = screens_.screen() == ui::Screen::play;
    pointer_.move_to(place);
    if (is_press && is_played && press_button(place)) {
        speaker_.play(sound::Sound::click);
        return;
    }
    if (giant() != nullptr && giant()->drag(change, is_played)) {
        if (change.kind == Kind::release) choose_giant(giant()->choose(giant()->share()));
        return;
    }
    if (!is_played && point_at_screen(change)) return;
    // What the pointer does while a game stands still is no swipe.
    if (screens_.holds_game()) return;
    const bool can_cut = screens_.screen() == ui::Screen::play || screens_.screen() == ui::Screen::menu;
    if (!is_press || can_cut) round_->point(change, size);
}

/// A button that is seen while a game is played. False: there is none.
bool GameFlow::press_button(const glm::vec2& place)
{
    if (const std::optional<ui::Pointed> pointed = pointer_.line_at(place, screens_)) {
        screens_.click(pointed->item);
        return true;
    }
    return giant() != nullptr && giant()->press_button(place);
}

/// True: the change was for the screen.
bool GameFlow::point_at_screen(const WindowPointer& change)
{
    if (change.kind == WindowPointer::Kind::press && unread_ > 0.0) return true;
    const LinePointer::Answer answer = pointer_.point(change, screens_, round_->blade_input().is_swiping());
    if (answer.request) carry_out(*answer.request);
    return answer.is_taken;
}

void GameFlow::let_play(game::Autopilot& autopilot)
{
    if (screens_.screen() == ui::Screen::play) round_->let_play(autopilot);
}

Attention GameFlow::attention() const
{
    if (screens_.holds_game()) return Attention::held;
    return screens_.screen() == ui::Screen::play ? Attention::played : Attention::watched;
}

void GameFlow::advance(double seconds)
{
    // In fixed steps the first tick waits for what a thread would make meanwhile: no frame of a player's.
    constexpr sim::Tick kMaking = 6;
    if (!setup_.fixed_step || (simulation() != nullptr && simulation()->now() > kMaking)) frames_.add(1e3 * seconds);
    const double frame_seconds = setup_.fixed_step ? double(sim::kTicksPerFrame) * sim::kTickSeconds : seconds;
    notice_.advance(frame_seconds);
    unread_ = std::max(0.0, unread_ - frame_seconds);
    notice_.say_next(scores_.take_message());
    if (screens_.screen() != ui::Screen::play && screens_.screen() != ui::Screen::settings) store_settings();

    RoundFrame frame{seconds, {painter_.target().width(), painter_.target().height()}, attention()};
    if (screens_.screen() == ui::Screen::menu)
        frame.mode = screens_.selected() < ui::modes().size() ? screens_.selected() : 0;
    models_.look_ahead(*round_, setup_.fixed_step);
    round_->advance(frame);
    follow_round();
}

/// What the round that has gone on leads to.
void GameFlow::follow_round()
{
    tell(round_->take_message());
    if (round_->has_cut_fruit()) is_new_player_ = false;
    keep_score(false);
    if (screens_.screen() == ui::Screen::play && round_->is_over()) {
        screens_.show(ui::Screen::over);
        unread_ = kResultsShown;
    }
    if (const std::string chosen = round_->chosen(); !chosen.empty()) start(chosen);
}

/// Once a game: when it is over, or when it is left.
void GameFlow::keep_score(bool is_left)
{
    const std::optional<PlayedGame> played = round_ ? round_->take_score(is_left) : std::nullopt;
    if (played) latest_place_ = scores_.add(played->mode, played->score);
}

std::optional<double> GameFlow::giant_progress()
{
    return giant() != nullptr ? giant()->progress(painter_.world().arriving()) : std::nullopt;
}

void GameFlow::paint(const ViewSettings& view)
{
    sync();
    round_->paint(painter_, view);
}

std::vector<std::pair<std::string, std::vector<ui::ScoreLine>>> GameFlow::score_lists() const
{
    std::vector<std::pair<std::string, std::vector<ui::ScoreLine>>> lists;
    for (const game::GameMode mode : game::kGameModes) {
        std::vector<ui::ScoreLine> lines;
        for (const game::HighScore& score : scores_.of(mode)) {
            const bool is_latest = latest_place_ && scene() == name_of(mode) && lines.size() == *latest_place_;
            lines.push_back({score.score, score.date.substr(0, 10), is_latest});
        }
        lists.emplace_back(std::string(ui::find_mode(name_of(mode))->title), std::move(lines));
    }
    return lists;
}

void GameFlow::write(ui::Canvas& canvas)
{
    const ui::Screen screen = screens_.screen();
    ui::ScreenContent content;
    content.message = notice_.text();
    content.pointer = pointer_.place();
    if (screen == ui::Screen::scores) content.scores = score_lists();
    round_->describe(content, screen);
    round_->write(canvas, {screen, !content.message.empty(), content.pointer, painter_.world().arriving()});
    pointer_.set_lines(ui::show_screen(canvas, screens_, content), screens_);
}

}  // namespace kerf::app
