#include "viewer/app/game/game_show.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "viewer/app/game/stone_asteroid.h"
#include "viewer/game/fruit_models.h"
#include "viewer/game/game_scene.h"
#include "viewer/game/scenes.h"
#include "viewer/game/stored_settings.h"
#include "viewer/sim/back_ends.h"
#include "viewer/ui/hud.h"
#include "viewer/ui/menu_scene.h"

namespace kerf::app {

namespace {

/// From the cut that chooses to the game that begins: time to see the juice.
constexpr sim::Tick kChoiceShown = 66;
/// From the end of a game to its balance.
constexpr sim::Tick kEndShown = 170;
/// Triangles of what stands for the giant on the menu.
constexpr std::uint64_t kSmallAsteroid = 3000;

game::StoredSettings settings_for(const ShowSetup& setup, std::string& message)
{
    game::LoadedSettings loaded = game::load_settings(setup.user_folder);
    message = std::move(loaded.message);
    if (!setup.backend.empty()) loaded.settings.backend = setup.backend;
    if (setup.fullscreen) loaded.settings.fullscreen = true;
    return loaded.settings;
}

}  // namespace

GameShow::GameShow(const ShowSetup& setup, Painter& painter, sound::Speaker& speaker)
    : setup_(setup), painter_(painter), speaker_(speaker), files_(setup.user_folder), screens_({}, sim::backend_names())
{
    std::string message;
    screens_.set_settings(settings_for(setup, message));
    stored_ = settings();
    tell(std::move(message));
    game::add_fruit_models(*models_, setup.data_folder / "fruit");
    models_->add("asteroid", stone_asteroid(kSmallAsteroid, 3));
    fruit_models_ = models_->size();
    speaker_.set_volume(settings().volume);
    speaker_.set_muted(settings().mute);
    start(setup.scene);
}

GameShow::~GameShow()
{
    keep_score();
}

void GameShow::start(const std::string& scene)
{
    keep_score();
    scene_ = scene;
    if (scene == "menu")
        screens_.show(ui::Screen::menu);
    else
        screens_.play(scene);
    store_settings();
    duel_.reset();
    simulation_.reset();
    painter_.forget_world();
    effects_ = {};
    soundtrack_ = {};
    clock_ = {};
    sampler_ = {};
    pointer_.clear();
    keyboard_blade_ = {};
    script_.clear();
    demo_ = {};
    demo_fruit_ = 0;
    swiping_ = false;
    pressed_.reset();
    unread_ = 0.0;
    wanted_.clear();
    over_at_.reset();
    latest_place_.reset();
    cut_times_ = {};
    speaker_.set_fuse(false);

    sim::Settings how;
    how.scene = scene;
    how.backend = settings().backend;
    how.proxy = setup_.proxy;
    how.seed = setup_.seed + games_++;
    how.record = setup_.record;
    if (scene == "duel") {
        duel_ = std::make_unique<DuelShow>(models_, how, setup_.boulder, setup_.duelists);
        if (setup_.fixed_step) duel_->wait_until_ready();
        return;
    }
    std::unique_ptr<sim::Scene> played;
    if (scene == "menu") {
        played = std::make_unique<ui::MenuScene>();
    } else {
        const std::optional<game::GameMode> mode = game::find_mode(scene);
        try {
            played =
                game::make_scene(scene, models_,
                                 {mode ? files_.best(*mode) : 0,
                                  setup_.fixed_step ? game::GiantArrival::at_once : game::GiantArrival::when_ready});
        } catch (const std::invalid_argument& error) {
            tell(error.what());
            return start("menu");
        }
        speaker_.play(sound::Sound::start);
    }
    simulation_ = std::make_unique<sim::Simulation>(models_, how, std::move(played));
    if (scene == "giant")
        simulation_->command("size " + std::to_string(setup_.giant > 0 ? setup_.giant : settings().giant));
}

void GameShow::carry_out(const ui::Request& request)
{
    using Kind = ui::Request::Kind;
    speaker_.play(sound::Sound::click);
    switch (request.kind) {
        case Kind::start:
            choose_mode(request.scene);
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
            store_settings();
            break;
    }
}

void GameShow::choose_mode(const std::string& scene)
{
    if (!wanted_.empty()) return;
    wanted_ = scene;
    wanted_at_ = simulation_->now();
    // The fruit is cut as the player would have done it.
    const ui::Mode* const mode = ui::find_mode(scene);
    const glm::dvec2 middle = ui::place_of_mode(static_cast<std::size_t>(mode - ui::modes().data()));
    constexpr int kSamples = 12;
    constexpr sim::Microseconds kStep = 9000;
    for (int i = 0; i <= kSamples; ++i) {
        const double share = 2.0 * double(i) / kSamples - 1.0;
        const auto kind = i == 0          ? sim::InputKind::press
                          : i == kSamples ? sim::InputKind::release
                                          : sim::InputKind::move;
        simulation_->push({simulation_->time() + 1 + i * kStep, kind, middle + share * glm::dvec2(1.7, 0.9), {}});
    }
}

void GameShow::store_settings()
{
    speaker_.set_volume(settings().volume);
    speaker_.set_muted(settings().mute);
    if (settings() == stored_) return;
    stored_ = settings();
    files_.store(stored_);
}

void GameShow::tell(std::string message)
{
    notice_.say(std::move(message));
}

bool GameShow::is_held() const
{
    return screens_.holds_game();
}

void GameShow::press(ui::MenuKey key)
{
    if (screens_.screen() == ui::Screen::play && (key == ui::MenuKey::left || key == ui::MenuKey::right)) {
        if (scene_ == "giant") set_giant(giant_share_ + (key == ui::MenuKey::left ? -0.1 : 0.1));
        return;
    }
    if (unread_ > 0.0 && (key == ui::MenuKey::accept || key == ui::MenuKey::back)) return;
    if (const std::optional<ui::Request> request = screens_.press(key)) carry_out(*request);
}

void GameShow::hold(ui::BladeKey key, bool is_down)
{
    if (is_down && (screens_.screen() != ui::Screen::play || swiping_)) return;
    keyboard_blade_.hold(key, is_down);
}

/// What the keys do goes the way of the mouse, so that recordings and rules know no difference.
void GameShow::move_keyboard_blade(double seconds)
{
    if (screens_.screen() != ui::Screen::play) {
        if (keyboard_blade_.is_cutting())
            pointer_.push_back({sim::PointerChange::Kind::release, keyboard_blade_.place()});
        return keyboard_blade_.let_go();
    }
    if (!keyboard_blade_.is_shown()) return;
    glm::dvec2 size(painter_.target().width(), painter_.target().height());
    if (duel_) size.x *= 0.5;
    const sim::Camera camera(size.x / size.y);
    const double zoom = duel_ ? double(DuelShow::kZoom) : 1.0;
    const glm::dvec2 reach = camera.ndc_to_stage({0.96, 0.95}) / zoom;  // the cross is seen whole
    for (const sim::PointerChange& change : keyboard_blade_.advance(seconds, reach)) pointer_.push_back(change);
}

void GameShow::toggle_mute()
{
    game::StoredSettings changed = settings();
    changed.mute = !changed.mute;
    screens_.set_settings(changed);
    store_settings();
    tell(changed.mute ? "Sound off" : "Sound on");
}

void GameShow::set_fullscreen(bool on)
{
    game::StoredSettings changed = settings();
    changed.fullscreen = on;
    screens_.set_settings(changed);
    store_settings();
}

void GameShow::play_again()
{
    if (screens_.screen() != ui::Screen::over || unread_ > 0.0) return;
    if (const std::optional<ui::Request> request = screens_.click(0)) carry_out(*request);
}

void GameShow::pause()
{
    if (screens_.screen() == ui::Screen::play) screens_.show(ui::Screen::paused);
}

void GameShow::show_screen(ui::Screen screen)
{
    screens_.show(screen);
}

/// A line of the screen as it was written; none when another one is shown since.
std::optional<ui::Pointed> GameShow::line_at(const glm::vec2& place) const
{
    if (hotspots_of_ != screens_.shown()) return std::nullopt;
    return ui::item_at(hotspots_, place);
}

/// A button that is seen while a game is played. False: there is none.
bool GameShow::press_button(const glm::vec2& place)
{
    if (const std::optional<ui::Pointed> pointed = line_at(place)) {
        screens_.click(pointed->item);
        speaker_.play(sound::Sound::click);
        return true;
    }
    if (scene_ != "giant") return false;
    for (std::size_t i = 0; i < giant_buttons_.size(); ++i) {
        if (!giant_buttons_[i].holds(place)) continue;
        speaker_.play(sound::Sound::click);
        i == 0 ? next_backend() : next_giant();
        return true;
    }
    return false;
}

void GameShow::point(const WindowPointer& change, const glm::vec2& size)
{
    using Kind = WindowPointer::Kind;
    const glm::vec2 place(change.position);
    const bool in_menu = screens_.screen() != ui::Screen::play;
    pointed_at_ = place;
    if (change.kind == Kind::press && !in_menu && press_button(place)) return;
    if (change.kind == Kind::press && giant_slider_.holds(place) && scene_ == "giant" && !in_menu)
        giant_sliding_ = true;
    if (giant_sliding_) {
        giant_share_ = double((place.x - giant_slider_.low.x) / std::max(giant_slider_.size().x, 1.0f));
        giant_share_ = std::clamp(giant_share_, 0.0, 1.0);
        if (change.kind == Kind::release) {
            giant_sliding_ = false;
            set_giant(giant_share_);
        }
        return;
    }
    if (in_menu) {
        if (change.kind == Kind::press && unread_ > 0.0) return;
        const std::optional<ui::Pointed> pointed = line_at(place);
        if (change.kind == Kind::release) sliding_.reset();
        if (pointed && change.kind == Kind::move && !swiping_) screens_.point_at(pointed->item);
        // A slider follows at once; other lines are chosen by pressing and letting go, so that no swipe across chooses.
        const auto pressed = change.kind == Kind::move ? pressed_ : std::exchange(pressed_, std::nullopt);
        if (pointed && change.kind == Kind::press) {
            if (screens_.items()[pointed->item].share)
                sliding_ = pointed->item;
            else
                pressed_.emplace(screens_.shown(), pointed->item);
        }
        const bool slides = change.kind != Kind::release && pointed && sliding_ == pointed->item;
        const bool chooses =
            change.kind == Kind::release && pointed && pressed == std::pair(screens_.shown(), pointed->item);
        if (slides || chooses)
            if (const auto request = screens_.click(pointed->item, pointed->share)) carry_out(*request);
        if (slides || chooses || pressed_) return;
    }
    // What the pointer does while a game stands still is no swipe.
    if (is_held()) return;
    const bool can_cut = screens_.screen() == ui::Screen::play || screens_.screen() == ui::Screen::menu;
    if (change.kind == Kind::press && !can_cut) return;
    if (change.kind != Kind::press && keyboard_blade_.is_cutting()) return;
    if (change.kind == Kind::press) {
        if (keyboard_blade_.is_cutting())
            pointer_.push_back({sim::PointerChange::Kind::release, keyboard_blade_.place()});
        keyboard_blade_.put_away();
    }
    ui::Box2 box{{0.0f, 0.0f}, size};
    // A swipe that leaves its half goes on beside it: in the other half it would begin at the far edge.
    if (change.kind == Kind::press || !swiping_) pressed_half_ = place.x < 0.5f * size.x ? 0 : 1;
    if (duel_) box = DuelShow::box_of_half(pressed_half_, size);
    const glm::dvec2 extent(box.size());
    if (extent.x < 1.0 || extent.y < 1.0) return;
    const sim::Camera camera(extent.x / extent.y);
    const auto kind = change.kind == Kind::press  ? sim::PointerChange::Kind::press
                      : change.kind == Kind::move ? sim::PointerChange::Kind::move
                                                  : sim::PointerChange::Kind::release;
    if (change.kind == Kind::press) swiping_ = true;
    if (change.kind == Kind::release) swiping_ = false;
    if (swiping_ && simulation_) touched_at_ = simulation_->now();
    const double zoom = duel_ ? double(DuelShow::kZoom) : 1.0;
    pointer_.push_back({kind, camera.screen_to_stage(glm::dvec2(place - box.low), extent) / zoom});
}

void GameShow::push(const std::vector<sim::InputEvent>& events)
{
    if (simulation_)
        simulation_->push(events);
    else
        script_.insert(script_.end(), events.begin(), events.end());
}

void GameShow::let_play(game::Autopilot& autopilot)
{
    if (screens_.screen() != ui::Screen::play) return;
    if (simulation_) return push(autopilot.play(*simulation_));
    if (!duel_->ready()) return;
    duel::Half& watched = duel_->duel().half(autopilot.swipes() % 2);
    if (watched.idle() && watched.done() == duel_->now()) push(autopilot.play(watched.simulation()));
}

void GameShow::advance(double seconds)
{
    // In fixed steps the first tick waits for what a thread would make meanwhile: no frame of a player's.
    constexpr sim::Tick kMaking = 6;
    if (!setup_.fixed_step || (simulation_ && simulation_->now() > kMaking)) frames_.add(1e3 * seconds);
    const double frame_seconds = setup_.fixed_step ? double(sim::kTicksPerFrame) * sim::kTickSeconds : seconds;
    notice_.advance(frame_seconds);
    unread_ = std::max(0.0, unread_ - frame_seconds);
    notice_.say_next(files_.take_message());
    double scale = effects_.time_scale();
    if (simulation_) scale *= simulation_->scene().time_scale();
    clock_.set_time_scale(scale);
    if (is_held() && !clock_.paused()) let_go();
    clock_.set_paused(is_held());
    move_keyboard_blade(frame_seconds);
    look_ahead();
    const sim::Tick ticks = !setup_.fixed_step ? clock_.advance(seconds) : is_held() ? 0 : sim::kTicksPerFrame;
    if (ticks > 0) simulate(ticks);
    fraction_ = setup_.fixed_step ? 1.0 : clock_.fraction();
}

/// The game stands still from now on: the blade ends where it is, and nothing hisses.
void GameShow::let_go()
{
    sampler_.let_go();
    pointer_.clear();
    keyboard_blade_.let_go();
    swiping_ = false;
    giant_sliding_ = false;
    speaker_.set_fuse(false);
}

/// Another thread makes ready what will be thrown: on the menu, whatever game is chosen.
void GameShow::look_ahead()
{
    if (!simulation_) return;
    std::vector<std::size_t> next = simulation_->scene().next_models();
    if (scene_ == "menu") {
        next.resize(fruit_models_);
        std::iota(next.begin(), next.end(), std::size_t(0));
    }
    preparer_.want(next, simulation_->backend(), simulation_->proxy());
    if (setup_.fixed_step) preparer_.finish();
}

void GameShow::simulate(sim::Tick ticks)
{
    if (duel_) {
        const sim::Tick end = duel_->now() + ticks;
        std::vector<sim::InputEvent> events = sampler_.frame(sim::time_of(duel_->now()), sim::time_of(end), pointer_);
        pointer_.clear();
        while (!script_.empty() && sim::tick_of(script_.front().time) <= end) {
            events.push_back(script_.front());
            script_.erase(script_.begin());
        }
        duel_->advance(ticks, events, setup_.fixed_step);
        watch_duel();
        return;
    }
    sim::Simulation& simulation = *simulation_;
    simulation.push(sampler_.frame(simulation.time(), sim::time_of(simulation.now() + ticks), pointer_));
    pointer_.clear();
    simulation.advance(ticks);
    if (std::string message = simulation.take_message(); !message.empty()) tell(std::move(message));
    effects_.follow(simulation);
    soundtrack_.follow(simulation, speaker_);
    cut_times_.follow(simulation.cuts());
    watch_game();
    watch_menu();
}

void GameShow::watch_duel()
{
    if (duel_->is_over() && screens_.screen() == ui::Screen::play) show_balance();
}

void GameShow::show_balance()
{
    screens_.show(ui::Screen::over);
    unread_ = kBalanceShown;
}

void GameShow::watch_game()
{
    const game::GameScene* const played = game::game_of(simulation_->scene());
    if (played == nullptr) return;
    const game::GameState& state = played->state();
    if (state.fruit_cut > 0) is_new_player_ = false;
    if (is_new_player_) show_first_cut(*played);
    if (state.phase != game::GamePhase::over) return;
    if (!over_at_) {
        keep_score();
        over_at_ = simulation_->now();
        speaker_.set_fuse(false);
    }
    if (simulation_->now() - *over_at_ >= kEndShown && screens_.screen() == ui::Screen::play) show_balance();
}

/// Once a game: when it is over, or when it is left.
void GameShow::keep_score()
{
    const game::GameScene* const played = simulation_ ? game::game_of(simulation_->scene()) : nullptr;
    if (played == nullptr || over_at_) return;
    const game::GameState& state = played->state();
    latest_place_ = files_.add(state.mode, game::score_of(state, simulation_->backend(), simulation_->settings().seed));
}

void GameShow::watch_menu()
{
    if (scene_ != "menu") return;
    move_demo_blade();
    const auto& menu = static_cast<const ui::MenuScene&>(simulation_->scene());
    const sim::Tick now = simulation_->now();
    if (menu.chosen() && wanted_.empty()) {
        wanted_ = ui::modes()[*menu.chosen()].scene;
        wanted_at_ = now;
    }
    if (!wanted_.empty() && now - wanted_at_ >= kChoiceShown + 12) start(std::string(wanted_));
}

void GameShow::move_demo_blade()
{
    constexpr sim::Tick kPeriod = 300, kStroke = 26, kPatience = 240;
    const sim::Tick now = simulation_->now();
    const std::size_t mode = screens_.selected() < ui::modes().size() ? screens_.selected() : 0;
    const sim::Tick phase = now % kPeriod - 60;
    if (phase < 0 || phase > kStroke || now - touched_at_ < kPatience || !wanted_.empty() ||
        screens_.screen() != ui::Screen::menu)
        return;
    const double share = 2.0 * double(phase) / kStroke - 1.0;
    const glm::dvec2 place = ui::place_of_mode(mode) + share * glm::dvec2(1.9, 1.1);
    if (phase <= 1) demo_.press(simulation_->time(), place);
    demo_.move(simulation_->time(), place);
}

void GameShow::sync()
{
    if (duel_)
        duel_->sync(painter_);
    else
        painter_.sync(*simulation_);
}

/// Who has cut nothing yet sees a blade go through a fruit that is near its apex. It cuts nothing.
void GameShow::show_first_cut(const game::GameScene& played)
{
    constexpr sim::Tick kStroke = 30;
    constexpr double kSlow = 3.5;  // m/s upwards: a fruit that is about to turn
    const sim::Microseconds time = simulation_->time();
    const sim::Body* fruit = simulation_->world().find(demo_fruit_);
    const bool is_on = fruit != nullptr && simulation_->now() - demo_start_ <= kStroke;
    for (const auto& body : simulation_->bodies()) {
        if (is_on) break;
        const std::optional<game::FruitKind> kind = played.whole(body->id());
        const bool is_new = kind && *kind != game::FruitKind::bomb && body->id() > demo_fruit_;
        if (!is_new || body->motion().velocity.y > kSlow) continue;
        fruit = body.get();
        demo_fruit_ = body->id();
        demo_start_ = simulation_->now();
        break;
    }
    if (fruit == nullptr || simulation_->now() - demo_start_ > kStroke) return;
    const double share = 2.0 * double(simulation_->now() - demo_start_) / kStroke - 1.0;
    const glm::dvec2 place = sim::Camera::seen_on_stage(fruit->centre()) + share * glm::dvec2(2.2, 1.2);
    if (simulation_->now() == demo_start_) demo_.press(time, place);
    demo_.move(time, place);
}

void GameShow::paint(const ViewSettings& view)
{
    sync();
    if (duel_) {
        const auto stages = duel_->stages(painter_.target().width(), painter_.target().height());
        ViewSettings nearer = view;
        nearer.zoom *= DuelShow::kZoom;
        painter_.paint(stages, nearer);
        return;
    }
    const bool teaches = scene_ == "menu" ? wanted_.empty() : is_new_player_;
    const bool shows_demo = teaches && !simulation_->blade().pressed() && !demo_.trail(simulation_->time()).empty();
    painter_.paint(*simulation_, view, fraction_, &effects_, shows_demo ? &demo_ : nullptr);
}

std::vector<std::pair<std::string, std::vector<ui::ScoreLine>>> GameShow::score_lists() const
{
    std::vector<std::pair<std::string, std::vector<ui::ScoreLine>>> lists;
    for (const game::GameMode mode : game::kGameModes) {
        std::vector<ui::ScoreLine> lines;
        for (const game::HighScore& score : files_.scores_of(mode)) {
            const bool is_latest = latest_place_ && scene_ == name_of(mode) && lines.size() == *latest_place_;
            lines.push_back({score.score, score.date.substr(0, 10), is_latest});
        }
        lists.emplace_back(std::string(ui::find_mode(name_of(mode))->title), std::move(lines));
    }
    return lists;
}

/// Where the keyboard's blade is; in a duel in both halves.
void GameShow::write_cross(ui::Canvas& canvas) const
{
    const double zoom = duel_ ? double(DuelShow::kZoom) : 1.0;
    for (std::size_t half = 0; half < (duel_ ? 2u : 1u); ++half) {
        const ui::Box2 box = duel_ ? DuelShow::box_of_half(half, canvas.size()) : ui::Box2{{0.0f, 0.0f}, canvas.size()};
        canvas.cross(ui::on_picture(zoom * keyboard_blade_.place(), box), keyboard_blade_.is_cutting());
    }
}

void GameShow::write(ui::Canvas& canvas)
{
    ui::ScreenContent content;
    content.message = notice_.text();
    content.pointer = pointed_at_;
    if (screens_.screen() == ui::Screen::scores) content.scores = score_lists();
    if (duel_ && screens_.screen() == ui::Screen::over)
        for (const duel::Score& score : duel_->scores())
            content.duel.push_back(
                {score.backend, score.cuts, score.cut_ms, score.worst_ms, score.worst_frame_ms, score.lost_frames});
    if (duel_) {
        if (screens_.screen() != ui::Screen::over) duel_->write(canvas);
    } else {
        ui::show_effects(canvas, effects_, {{0.0f, 0.0f}, canvas.size()});
        if (const game::GameScene* const played = game::game_of(simulation_->scene())) {
            content.game = &played->state();
            // What is said stands where the hint would be.
            const bool teaches = is_new_player_ && screens_.screen() == ui::Screen::play && content.message.empty();
            if (screens_.screen() != ui::Screen::over)
                ui::show_hud(canvas, played->state(), teaches ? ui::kHowToPlay : std::string_view());
        }
        if (scene_ == "giant") write_giant(canvas);
    }
    if (screens_.screen() == ui::Screen::play && keyboard_blade_.is_shown()) write_cross(canvas);
    hotspots_ = ui::show_screen(canvas, screens_, content);
    hotspots_of_ = screens_.shown();
}

}  // namespace kerf::app
