#include "viewer/app/game/demo_blade.h"

#include "viewer/sim/camera.h"
#include "viewer/ui/screen_view.h"

namespace kerf::app {

namespace {

/// Of a stroke, -1 to 1.
double along(sim::Tick now, sim::Tick length)
{
    return 2.0 * double(now) / double(length) - 1.0;
}

}  // namespace

void DemoBlade::show_on_menu(const sim::Simulation& simulation, std::size_t mode)
{
    constexpr sim::Tick kPeriod = 300, kStart = 60, kStroke = 26;
    const sim::Tick phase = simulation.now() % kPeriod - kStart;
    if (phase < 0 || phase > kStroke) return;
    const glm::dvec2 place = ui::place_of_mode(mode) + along(phase, kStroke) * glm::dvec2(1.9, 1.1);
    if (phase <= 1) blade_.press(simulation.time(), place);
    blade_.move(simulation.time(), place);
}

void DemoBlade::show_in_game(const sim::Simulation& simulation, const game::GameScene& played)
{
    constexpr sim::Tick kStroke = 30;
    const sim::Body* fruit = simulation.world().find(fruit_);
    if (fruit == nullptr || simulation.now() - start_ > kStroke) fruit = next_fruit(simulation, played);
    if (fruit == nullptr) return;
    const sim::Tick phase = simulation.now() - start_;
    const glm::dvec2 place = sim::Camera::seen_on_stage(fruit->centre()) + along(phase, kStroke) * glm::dvec2(2.2, 1.2);
    if (phase == 0) blade_.press(simulation.time(), place);
    blade_.move(simulation.time(), place);
}

const sim::Body* DemoBlade::next_fruit(const sim::Simulation& simulation, const game::GameScene& played)
{
    constexpr double kSlow = 3.5;  // m/s upwards: a fruit that is about to turn
    for (const auto& body : simulation.bodies()) {
        const std::optional<game::FruitKind> kind = played.whole(body->id());
        const bool is_new = kind && *kind != game::FruitKind::bomb && body->id() > fruit_;
        if (!is_new || body->motion().velocity.y > kSlow) continue;
        fruit_ = body->id();
        start_ = simulation.now();
        return body.get();
    }
    return nullptr;
}

}  // namespace kerf::app
