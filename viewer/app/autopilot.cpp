#include "viewer/app/autopilot.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "common/shapes/random.h"
#include "viewer/sim/camera.h"

namespace kerf::app {

namespace {

constexpr sim::Microseconds kSwipe = 100'000;  // how long a swipe takes
constexpr sim::Microseconds kRest = 180'000;   // between two swipes
constexpr sim::Microseconds kSample = 1'000'000 / 120;
constexpr double kSmallest = 0.35;       // metres: smaller pieces are left alone
constexpr std::size_t kMostPieces = 24;  // on the stage; then it waits for some to leave

/// Where the eye sees a place of the world on the stage.
glm::dvec2 on_stage(const glm::dvec3& place)
{
    return glm::dvec2(place) * sim::kEyeDistance / (sim::kEyeDistance - place.z);
}

/// The largest piece well inside the stage; null when there is none.
const sim::Body* target_of(const sim::Simulation& simulation)
{
    const sim::Body* best = nullptr;
    for (const auto& body : simulation.bodies()) {
        const glm::dvec2 place = on_stage(body->centre());
        const bool is_well_inside =
            std::abs(place.x) < 0.9 * sim::kStageHalfWidth && std::abs(place.y) < 0.75 * sim::kStageHalfHeight;
        if (!is_well_inside || body->radius() < kSmallest) continue;
        if (best == nullptr || body->mass() > best->mass()) best = body.get();
    }
    return best;
}

}  // namespace

std::vector<sim::InputEvent> Autopilot::play(const sim::Simulation& simulation)
{
    const sim::Microseconds now = simulation.time();
    if (now < busy_until_ || simulation.bodies().size() > kMostPieces) return {};
    const sim::Body* const target = target_of(simulation);
    if (target == nullptr) return {};

    shapes::Random random(shapes::Random::mix(seed_ + ++swipes_));
    const double angle = glm::two_pi<double>() * random.unit();
    const glm::dvec3 velocity = target->motion().velocity;
    const glm::dvec2 middle = on_stage(target->centre() + 0.5e-6 * double(kSwipe) * velocity);
    const glm::dvec2 reach = (target->radius() + 0.6) * glm::dvec2(std::cos(angle), std::sin(angle));
    std::vector<sim::InputEvent> events;
    const auto add = [&](sim::Microseconds time, sim::InputKind kind) {
        const double share = double(time - now) / double(kSwipe);
        events.push_back({time, kind, middle + (2.0 * share - 1.0) * reach, {}});
    };
    add(now + 1, sim::InputKind::press);
    for (sim::Microseconds time = now + kSample; time < now + kSwipe; time += kSample) add(time, sim::InputKind::move);
    add(now + kSwipe, sim::InputKind::release);
    busy_until_ = now + kSwipe + kRest;
    return events;
}

}  // namespace kerf::app
