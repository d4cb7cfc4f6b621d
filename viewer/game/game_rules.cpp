#include "viewer/game/game_rules.h"

#include <algorithm>

namespace kerf::game {
namespace {

constexpr std::array<FruitKind, 4> kSpecials{FruitKind::freeze, FruitKind::frenzy, FruitKind::double_points,
                                             FruitKind::hammer};
constexpr std::array<sim::Tick, 4> kSpecialTicks{kFreezeTicks, kFrenzyTicks, kDoubleTicks, kHammerTicks};

std::size_t index_of(FruitKind special)
{
    return static_cast<std::size_t>(special) - static_cast<std::size_t>(FruitKind::freeze);
}

GameEvent make_event(sim::Tick now, GameEventKind kind, std::int64_t points = 0, int count = 0)
{
    GameEvent event;
    event.tick = now;
    event.kind = kind;
    event.points = points;
    event.count = count;
    return event;
}

GameEvent make_event(sim::Tick now, GameEventKind kind, FruitKind fruit, const glm::dvec2& place, sim::ObjectId object)
{
    GameEvent event = make_event(now, kind);
    event.fruit = fruit;
    event.place = place;
    event.object = object;
    return event;
}

GameEvent as(GameEventKind kind, GameEvent event)
{
    event.kind = kind;
    event.points = 0;
    return event;
}

}  // namespace

GameRules::GameRules(GameMode mode, std::int64_t best) : rules_(rules_of(mode)), best_before_(best)
{
    state_.mode = mode;
    state_.lives = state_.lives_at_start = rules_.lives;
    show();
}

void GameRules::tick(sim::Tick now, std::uint32_t swipe, bool pressed)
{
    if (is_over()) return;
    pay(combo_.tick(swipe, pressed, now), now);
    if (!is_active(FruitKind::freeze)) ++played_;
    run_specials(now);
    if (rules_.duration > 0 && played_ >= rules_.duration) end(now, GameEnd::time);
    show();
}

void GameRules::run_specials(sim::Tick now)
{
    for (const FruitKind kind : kSpecials) {
        Special& special = special_of(kind);
        if (special.left == 0 || --special.left > 0) continue;
        GameEvent event = make_event(now, GameEventKind::special_ended);
        event.fruit = kind;
        events_.push_back(event);
    }
}

void GameRules::start_wave(sim::Tick now)
{
    if (is_over()) return;
    ++state_.wave;
    events_.push_back(make_event(now, GameEventKind::wave, 0, state_.wave));
}

void GameRules::thrown(sim::Tick now, FruitKind kind, const glm::dvec2& place, sim::ObjectId object)
{
    if (!is_over()) events_.push_back(make_event(now, GameEventKind::thrown, kind, place, object));
}

void GameRules::cut(const Cut& cut)
{
    if (is_over()) return;
    GameEvent event = make_event(cut.tick, GameEventKind::fruit_cut, cut.kind, cut.place, cut.object);
    event.cut = cut.number;
    if (cut.kind == FruitKind::bomb) {
        cut_bomb(event);
    } else {
        cut_fruit(cut, event);
    }
    show();
}

void GameRules::cut_fruit(const Cut& cut, const GameEvent& event)
{
    ++state_.counts.fruit_cut;
    pay(combo_.add(cut.swipe, cut.tick, cut.place), cut.tick);
    earn(event, fruit_of(cut.kind).points);
    if (is_special(cut.kind)) {
        start_special(event);
    } else if (!smashes(cut.kind) && cut.lighter_share >= kCriticalShare) {
        ++state_.counts.criticals;
        earn(as(GameEventKind::critical, event), kCriticalPoints);
    }
}

void GameRules::cut_bomb(GameEvent event)
{
    ++state_.counts.bombs_cut;
    event.kind = GameEventKind::bomb;
    if (!rules_.bomb_ends) event.points = -std::min<std::int64_t>(kBombCost, state_.score);
    state_.score += event.points;
    events_.push_back(event);
    if (rules_.bomb_ends) end(event.tick, GameEnd::bomb);
}

void GameRules::start_special(GameEvent event)
{
    const FruitKind kind = *event.fruit;
    const sim::Tick lasts = kSpecialTicks[index_of(kind)];
    special_of(kind) = {lasts, lasts};
    events_.push_back(as(GameEventKind::special_started, event));
}

void GameRules::gone(sim::Tick now, FruitKind kind, const glm::dvec2& place, sim::ObjectId object)
{
    if (is_over() || kind == FruitKind::bomb || is_special(kind)) return;
    ++state_.counts.fruit_missed;
    GameEvent event = make_event(now, GameEventKind::missed, kind, place, object);
    events_.push_back(event);
    if (rules_.lives == 0) return;
    event.kind = GameEventKind::life_lost;
    event.count = --state_.lives;
    events_.push_back(event);
    if (state_.lives == 0) end(now, GameEnd::missed);
}

void GameRules::give_up(sim::Tick now)
{
    if (!is_over()) end(now, GameEnd::given_up);
}

void GameRules::earn(GameEvent event, std::int64_t points)
{
    event.points = points * (is_active(FruitKind::double_points) ? kDoubleMultiplier : 1);
    state_.score += event.points;
    events_.push_back(event);
    if (rules_.life_points == 0) return;
    for (; (lives_earned_ + 1) * rules_.life_points <= state_.score; ++lives_earned_) {
        if (state_.lives >= kMostLives) continue;
        event = as(GameEventKind::extra_life, event);
        event.count = ++state_.lives;
        events_.push_back(event);
    }
}

void GameRules::pay(const std::optional<Combo::Closed>& combo, sim::Tick now)
{
    if (!combo) return;
    ++state_.counts.combos;
    state_.counts.longest_combo = std::max(state_.counts.longest_combo, combo->fruit);
    GameEvent event = make_event(now, GameEventKind::combo, 0, combo->fruit);
    event.place = combo->place;
    earn(event, combo->fruit);
}

void GameRules::end(sim::Tick now, GameEnd end)
{
    pay(combo_.close(), now);
    state_.phase = GamePhase::over;
    state_.end = end;
    events_.push_back(make_event(now, GameEventKind::game_over, state_.score));
    show();
}

bool GameRules::smashes(FruitKind kind) const
{
    return kind == FruitKind::frozen || (kind != FruitKind::bomb && !is_over() && is_active(FruitKind::hammer));
}

double GameRules::time_scale() const
{
    return !is_over() && is_active(FruitKind::freeze) ? kFrozenTimeScale : 1.0;
}

void GameRules::show()
{
    // A first game has nothing to beat.
    state_.is_best = best_before_ > 0 && state_.score > best_before_;
    state_.best = state_.is_best ? state_.score : best_before_;
    state_.combo = combo_.fruit();
    state_.multiplier = is_active(FruitKind::double_points) ? kDoubleMultiplier : 1;
    if (rules_.duration > 0)
        state_.seconds_left = double(std::max<sim::Tick>(rules_.duration - played_, 0)) * sim::kTickSeconds;
    state_.specials.clear();
    if (is_over()) return;
    for (const FruitKind kind : kSpecials) {
        const Special& special = special_of(kind);
        if (special.left == 0) continue;
        state_.specials.push_back({kind, double(special.left) * sim::kTickSeconds / time_scale(),
                                   double(special.left) / double(special.whole)});
    }
}

void GameRules::hash(sim::StateHash& hash) const
{
    hash.add(std::uint64_t(state_.mode));
    hash.add(std::uint64_t(state_.phase));
    hash.add(state_.score);
    hash.add(std::int64_t(state_.lives));
    hash.add(std::int64_t(state_.wave));
    hash.add(lives_earned_);
    hash.add(played_);
    for (const Special& special : specials_) hash.add(special.left);
    combo_.hash(hash);
}

const GameRules::Special& GameRules::special_of(FruitKind kind) const
{
    return specials_[index_of(kind)];
}

GameRules::Special& GameRules::special_of(FruitKind kind)
{
    return specials_[index_of(kind)];
}

}  // namespace kerf::game
