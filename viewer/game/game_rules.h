#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "viewer/game/combo.h"
#include "viewer/game/game_events.h"
#include "viewer/game/game_state.h"

namespace kerf::game {

/// A whole fruit or bomb that was cut, as the rules see it.
struct Cut
{
    FruitKind kind = FruitKind::apple;
    sim::Tick tick = 0;
    std::uint32_t swipe = 0;
    glm::dvec2 place{0.0};       ///< on the stage
    double lighter_share = 0.0;  ///< of its mass, on the lighter side of the cut: 0 to 0.5
    sim::ObjectId object = 0;
    std::uint64_t number = 0;  ///< of its CutRecord
};

/// Counts: points, lives, combos, the effects of special fruit, the clock. Knows what happened, but no physics: told in
/// the order of ticks, it gives the same events every time. After the game is over nothing counts.
class GameRules
{
public:
    explicit GameRules(GameMode mode, std::int64_t best = 0);

    /// Once a tick, before what happens in it.
    /// @param swipe, pressed  of the blade: its last swipe, and whether that is still under way
    void tick(sim::Tick now, std::uint32_t swipe, bool pressed);
    void start_wave(sim::Tick now);
    void thrown(sim::Tick now, FruitKind kind, const glm::dvec2& place, sim::ObjectId object);
    void cut(const Cut& cut);
    /// A whole fruit or bomb has left the stage.
    void gone(sim::Tick now, FruitKind kind, const glm::dvec2& place, sim::ObjectId object);
    void give_up(sim::Tick now);

    const GameState& state() const { return state_; }
    std::span<const GameEvent> events() const { return events_; }
    bool is_over() const { return state_.phase == GamePhase::over; }
    bool is_active(FruitKind special) const { return special_of(special).left > 0; }
    /// Ticks since the effect of a special fruit began.
    sim::Tick age(FruitKind special) const { return special_of(special).whole - special_of(special).left; }
    /// Whether the blade smashes such a fruit when it is whole, instead of cutting it. What is smashed has no halves, so it
    /// is never cut critically.
    bool smashes(FruitKind kind) const;
    double time_scale() const;

    void hash(sim::StateHash& hash) const;

private:
    struct Special
    {
        sim::Tick left = 0, whole = 0;  ///< ticks; left == 0: not active
    };

    void cut_fruit(const Cut& cut, const GameEvent& event);
    void cut_bomb(GameEvent event);
    void start_special(GameEvent event);
    void run_specials(sim::Tick now);
    /// Adds points, times the multiplier, with their event and the lives that they earn.
    void earn(GameEvent event, std::int64_t points);
    void pay(const std::optional<Combo::Closed>& combo, sim::Tick now);
    void end(sim::Tick now, GameEnd end);
    /// Brings what state_ tells of other members up to date.
    void show();
    const Special& special_of(FruitKind kind) const;
    Special& special_of(FruitKind kind);

    GameState state_;
    Rules rules_;
    std::vector<GameEvent> events_;
    Combo combo_;
    std::array<Special, 4> specials_;
    sim::Tick played_ = 0;  ///< of the game's clock, which freezing stops
    std::int64_t best_before_ = 0, lives_earned_ = 0;
};

}  // namespace kerf::game
