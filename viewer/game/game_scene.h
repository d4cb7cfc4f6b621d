#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <span>

#include "viewer/game/game_rules.h"
#include "viewer/game/waves.h"
#include "viewer/sim/model_library.h"
#include "viewer/sim/scene.h"

namespace kerf::game {

/// A game in one of its modes: throws waves and tells GameRules what becomes of them. Numbers: docs/game.md.
///
/// A fruit counts once, when it is cut whole; cutting pieces again is fun and earns nothing. What counts is that the
/// cut went through the solid, not that the blade touched its proxy.
class GameScene : public sim::Scene
{
public:
    /// @param models  must hold the models of all fruit that the mode throws, under Fruit::model
    /// @param best    score to beat
    /// @throws std::invalid_argument  a model is missing
    GameScene(GameMode mode, const sim::ModelLibrary& models, std::int64_t best = 0);

    std::string_view name() const override { return name_of(mode_); }
    double gravity() const override { return kGameGravity; }
    double time_scale() const override { return rules_.time_scale(); }
    void tick(sim::Simulation& simulation) override;
    void on_cut(sim::Simulation& simulation, const sim::CutRecord& cut) override;
    std::optional<sim::Breaking> smashes(const sim::Body& body) const override;
    std::size_t most_pieces() const override;
    void on_smashed(sim::Simulation& simulation, const sim::Body& body, std::uint32_t swipe) override;
    void on_gone(sim::Simulation& simulation, const sim::Body& body) override;
    /// `over` ends the game: the player gives up.
    bool command(sim::Simulation& simulation, std::string_view verb, std::string_view argument) override;
    /// What is left of the wave, then everything else that the mode throws.
    std::vector<std::size_t> next_models() const override;
    void hash(sim::StateHash& hash) const override;

    const GameState& state() const { return rules_.state(); }
    /// All events since the start, oldest first.
    std::span<const GameEvent> events() const { return rules_.events(); }
    /// What a body is as long as it is whole; empty for pieces.
    std::optional<FruitKind> whole(sim::ObjectId id) const;
    /// Whether a blade that meets this object smashes it instead of cutting it: it is a whole frozen fruit, or the
    /// hammer's time runs and it is a whole fruit and no bomb.
    bool bursts(sim::ObjectId id) const;

private:
    void run_frenzy(sim::Simulation& simulation);
    void run_waves(sim::Simulation& simulation);
    void throw_fruit(sim::Simulation& simulation, const PlannedThrow& what);

    GameMode mode_;
    GameRules rules_;
    std::array<std::size_t, kFruitKinds> models_{};  ///< in the library
    std::map<sim::ObjectId, FruitKind> flying_;      ///< whole fruit and bombs in the air
    Wave wave_;
    std::size_t next_throw_ = 0;  ///< of wave_
    sim::Tick wave_start_ = 0;
    sim::Tick next_wave_ = kGetReady;  ///< when it starts at the latest
    std::uint64_t frenzy_throws_ = 0;
};

/// The game that a scene is; null when it is none.
const GameScene* game_of(const sim::Scene& scene);

}  // namespace kerf::game
