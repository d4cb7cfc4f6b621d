#include "viewer/game/autopilot.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "common/support/random.h"
#include "viewer/sim/camera.h"

namespace kerf::game {
namespace {

using sim::kStageHalfHeight, sim::kStageHalfWidth;

constexpr sim::Microseconds kSwipe = 100'000;     // how long a swipe takes
constexpr sim::Microseconds kRest = 180'000;      // between two swipes
constexpr sim::Microseconds kGameRest = 100'000;  // the same in a game, where there is more to do
constexpr sim::Microseconds kSample = 1'000'000 / 120;
constexpr sim::Microseconds kBlowRest = 600'000;  // between two blows
constexpr double kSmallest = 0.35;                // metres: smaller pieces are left alone
constexpr std::size_t kMostPieces = 24;           // on the stage; then it waits for some to leave
constexpr double kBeyond = 0.6;                   // metres that a stroke goes beyond its target

// In games.
constexpr int kStrokes = 24;           // that it thinks of
constexpr double kLongestReach = 3.5;  // half of a stroke's length, metres
constexpr double kMostBeside = 0.3;    // of its target's radius: nobody hits the middle every time
constexpr double kHit = 0.45;          // a stroke this near to the centre cuts, shares of the radius
constexpr double kBombMargin = 0.35;   // metres that a bomb's hull is given a wide berth by

/// A straight swipe from middle - reach to middle + reach.
struct Stroke
{
    glm::dvec2 middle{0.0}, reach{0.0};
};

bool is_inside(const glm::dvec2& place)
{
    return std::abs(place.x) < 0.9 * kStageHalfWidth && std::abs(place.y) < 0.75 * kStageHalfHeight;
}

/// The largest piece well inside the stage; null when there is none.
const sim::Body* target_of(const sim::Simulation& simulation)
{
    const sim::Body* best = nullptr;
    for (const auto& body : simulation.bodies()) {
        const bool is_well_inside = is_inside(sim::Camera::seen_on_stage(body->centre()));
        if (!is_well_inside || body->radius() < kSmallest) continue;
        if (best == nullptr || body->mass() > best->mass()) best = body.get();
    }
    return best;
}

std::optional<Stroke> stroke_at_largest(const sim::Simulation& simulation, core::Random& random)
{
    const sim::Body* const target = target_of(simulation);
    if (target == nullptr || simulation.bodies().size() > kMostPieces) return std::nullopt;
    const double angle = glm::two_pi<double>() * random.unit();
    const glm::dvec3 velocity = target->motion().velocity;
    const glm::dvec2 middle = sim::Camera::seen_on_stage(target->centre() + 0.5e-6 * double(kSwipe) * velocity);
    const glm::dvec2 reach = (target->radius() + kBeyond) * glm::dvec2(std::cos(angle), std::sin(angle));
    return Stroke{middle, reach};
}

/// A whole fruit or bomb and how it flies on.
struct Mark
{
    FruitKind kind;
    double radius;
    glm::dvec3 centre, velocity;

    /// Where it is seen after so many seconds.
    glm::dvec2 after(double seconds) const
    {
        const glm::dvec3 fall(0.0, -0.5 * kGameGravity * seconds * seconds, 0.0);
        return sim::Camera::seen_on_stage(centre + seconds * velocity + fall);
    }
};

std::vector<Mark> marks_of(const sim::Simulation& simulation, const GameScene& game)
{
    std::vector<Mark> marks;
    for (const auto& body : simulation.bodies())
        if (const std::optional<FruitKind> kind = game.whole(body->id()))
            marks.push_back({*kind, body->radius(), body->centre(), body->motion().velocity});
    return marks;
}

double distance_to(const Stroke& stroke, const glm::dvec2& place)
{
    const glm::dvec2& reach = stroke.reach;
    const double share = glm::clamp(glm::dot(place - stroke.middle, reach) / glm::dot(reach, reach), -1.0, 1.0);
    return glm::distance(place, stroke.middle + share * reach);
}

/// What a stroke is worth: the fruit that it cuts; less than nothing when it comes near a bomb.
int value_of(const Stroke& stroke, const std::vector<Mark>& marks)
{
    constexpr double kSeconds = 1e-6 * double(kSwipe);
    int fruit = 0;
    for (const Mark& mark : marks) {
        if (mark.kind == FruitKind::bomb) {
            for (const double share : {0.0, 0.5, 1.0})
                if (distance_to(stroke, mark.after(share * kSeconds)) < mark.radius + kBombMargin) return -1;
        } else if (distance_to(stroke, mark.after(0.5 * kSeconds)) < kHit * mark.radius) {
            ++fruit;
        }
    }
    return fruit;
}

std::optional<Stroke> best_stroke(const sim::Simulation& simulation, const GameScene& game, core::Random& random)
{
    const std::vector<Mark> marks = marks_of(simulation, game);
    std::vector<Mark> targets;
    for (const Mark& mark : marks)
        if (mark.kind != FruitKind::bomb && is_inside(mark.after(0.5e-6 * double(kSwipe)))) targets.push_back(mark);
    if (targets.empty()) return std::nullopt;

    std::optional<Stroke> best;
    int most = 0;
    for (int i = 0; i < kStrokes; ++i) {
        const Mark& target = targets[random.below(std::uint32_t(targets.size()))];
        const double angle = glm::two_pi<double>() * random.unit();
        const glm::dvec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
        const double shortest = target.radius + kBeyond;
        const double reach = shortest + (kLongestReach - shortest) * random.unit();
        const glm::dvec2 middle =
            target.after(0.5e-6 * double(kSwipe)) + (2.0 * random.unit() - 1.0) * kMostBeside * target.radius * across;
        const Stroke stroke{middle, reach * along};
        if (const int value = value_of(stroke, marks); value > most) {
            most = value;
            best = stroke;
        }
    }
    return best;
}

}  // namespace

/// A click on the largest piece.
std::vector<sim::InputEvent> Autopilot::blow_at_largest(const sim::Simulation& simulation)
{
    const sim::Body* const target = target_of(simulation);
    if (target == nullptr) return {};
    ++swipes_;
    const sim::Microseconds now = simulation.time();
    const glm::dvec2 place = sim::Camera::seen_on_stage(target->centre());
    busy_until_ = now + kBlowRest;
    return {{now + 1, sim::InputKind::press, place, {}}, {now + kSample, sim::InputKind::release, place, {}}};
}

std::vector<sim::InputEvent> Autopilot::play(const sim::Simulation& simulation)
{
    const sim::Microseconds now = simulation.time();
    if (now < busy_until_) return {};
    core::Random random(core::Random::mix(seed_ + swipes_ + 1));
    if (simulation.scene().takes_presses()) return blow_at_largest(simulation);
    const GameScene* const game = game_of(simulation.scene());
    const std::optional<Stroke> stroke =
        game != nullptr ? best_stroke(simulation, *game, random) : stroke_at_largest(simulation, random);
    if (!stroke) return {};
    ++swipes_;

    std::vector<sim::InputEvent> events;
    const auto add = [&](sim::Microseconds time, sim::InputKind kind) {
        const double share = double(time - now) / double(kSwipe);
        events.push_back({time, kind, stroke->middle + (2.0 * share - 1.0) * stroke->reach, {}});
    };
    add(now + 1, sim::InputKind::press);
    for (sim::Microseconds time = now + kSample; time < now + kSwipe; time += kSample) add(time, sim::InputKind::move);
    add(now + kSwipe, sim::InputKind::release);
    busy_until_ = now + kSwipe + (game != nullptr ? kGameRest : kRest);
    return events;
}

}  // namespace kerf::game
