#pragma once

#include <memory>
#include <string>
#include <vector>

#include "viewer/game/game_scene.h"
#include "viewer/sim/simulation.h"

namespace kerf::test {

/// Stand-ins for all kinds of fruit, of some hundred triangles each: balls, an egg for the lemon, a long one for the
/// banana and the pineapple, a hollow one for the coconut. Rules don't depend on looks.
std::shared_ptr<sim::ModelLibrary> fruit_library();

/// The game's own fruit, read once.
std::shared_ptr<sim::ModelLibrary> real_fruit();

/// A game under way.
class Game
{
public:
    explicit Game(game::GameMode mode, std::uint64_t seed = 1, const std::string& backend = {},
                  const std::shared_ptr<sim::ModelLibrary>& models = fruit_library());

    sim::Simulation& simulation() const { return *simulation_; }
    const game::GameScene& scene() const { return *game::game_of(simulation_->scene()); }
    const game::GameState& state() const { return scene().state(); }
    bool is_over() const { return state().phase == game::GamePhase::over; }
    std::vector<game::GameEvent> events(game::GameEventKind kind) const;

    /// Advances until `condition` holds; false when it does not within so many ticks.
    template <class Condition>
    bool play_until(Condition condition, sim::Tick at_most = 60 * sim::kTicksPerSecond)
    {
        for (sim::Tick i = 0; i < at_most && !condition(); ++i) simulation_->advance();
        return condition();
    }

    /// A whole object that flies well inside the stage; of any kind of fruit, or of one kind. Null: there is none.
    const sim::Body* find_fruit() const;
    const sim::Body* find(game::FruitKind kind) const;

    /// Swipes through a body within one tick: a straight stroke of 4 m, `beside` metres beside its centre. Plays it.
    void swipe_through(const sim::Body& body, double beside = 0.0);
    /// The same, as part of a swipe that begins with press() and ends with release().
    void press(const glm::dvec2& place);
    void sweep_through(const sim::Body& body);
    void release();

private:
    bool is_well_inside(const sim::Body& body) const;
    void push(sim::InputKind kind, const glm::dvec2& place);

    std::unique_ptr<sim::Simulation> simulation_;
    sim::Microseconds next_ = 0;  ///< time of the next event
    glm::dvec2 pointer_{0.0};
};

}  // namespace kerf::test
