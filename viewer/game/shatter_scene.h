#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "viewer/sim/scene.h"

namespace kerf::game {

/// The names of FracturePattern, in its order: what the command `pattern` takes.
inline constexpr std::array<std::string_view, 5> kPatternNames{"uniform", "impact", "crack", "grid", "splinters"};

/// What a click does in the scene, as the player chose it.
struct ShatterSettings
{
    static constexpr std::uint32_t kFewestCells = 2, kMostCells = 300;
    static constexpr double kMostStrength = 5000.0;

    std::uint32_t cells = 40;
    FracturePattern pattern = FracturePattern::impact;
    /// Breaking::strength. At this one a blow takes a corner off a model, and three or four leave nothing of it.
    double strength = 500.0;
};

/// Models are thrown, slowly, and a click is a blow with a hammer: it cracks what it hits. Pieces hang together until a
/// blow, or another object, deals their contacts more than they hold.
///
/// Commands: `throw [MODEL]` throws now, `repeat` throws the last one again; `cells N`, `pattern NAME`, `strength N` say how
/// things break from now on.
class ShatterScene : public sim::Scene
{
public:
    std::string_view name() const override { return "shatter"; }
    double gravity() const override;
    void tick(sim::Simulation& simulation) override;
    bool takes_presses() const override { return true; }
    void on_press(sim::Simulation& simulation, const glm::dvec2& place) override;
    std::optional<sim::Breaking> crashes(const sim::Body& body, double impulse) const override;
    double least_impact() const override;
    void on_broken(sim::Simulation& simulation, const sim::BreakRecord& broken) override;
    std::size_t most_pieces() const override { return ShatterSettings::kMostCells; }
    bool command(sim::Simulation& simulation, std::string_view verb, std::string_view argument) override;
    std::vector<std::size_t> next_models() const override { return {next_model_}; }
    void hash(sim::StateHash& hash) const override;

    const ShatterSettings& settings() const { return settings_; }

private:
    void throw_next(sim::Simulation& simulation);
    sim::Breaking breaking() const;

    ShatterSettings settings_;
    std::size_t next_model_ = 0;
    std::uint64_t throws_ = 0;
    sim::Tick next_throw_ = 0;  ///< the earliest tick of the next one
};

/// The scene if it is this one; null otherwise.
const ShatterScene* shatter_of(const sim::Scene& scene);

}  // namespace kerf::game
