#include "viewer/game/shatter_scene.h"

#include <algorithm>
#include <charconv>
#include <glm/geometric.hpp>
#include <string>

#include "viewer/sim/camera.h"
#include "viewer/sim/simulation.h"

namespace kerf::game {
namespace {

/// There is time to aim, m/s^2.
constexpr double kShatterGravity = 3.0;
/// Half the diagonal of a thrown model's box, metres.
constexpr double kShatterRadius = 1.9;
/// The impulse of a blow, N s: it makes a model of a ton go a metre in a second.
constexpr double kBlow = 1000.0;
/// A whole model that is dealt more than this by another one cracks, N s.
constexpr double kCrash = 200.0;
/// Nothing weaker is looked at, N s.
constexpr double kLeastImpact = 20.0;
/// A piece that hangs on nothing breaks again if its radius is at least this, metres, into so many cells.
constexpr double kSmallestToBreak = 0.35;
constexpr std::uint32_t kCellsOfPiece = 6;
/// From a break to the next throw: most of its pieces are gone then.
constexpr sim::Tick kPause = 3 * sim::kTicksPerSecond;

/// A whole number, or a decimal one, in a range.
template <class Number>
bool parse(std::string_view text, Number least, Number most, Number& number)
{
    Number parsed{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed);
    if (error != std::errc() || end != text.data() + text.size() || !(parsed >= least && parsed <= most)) return false;
    number = parsed;
    return true;
}

std::string refusal(std::string_view what, std::string_view given)
{
    std::string text(what);
    text += ", not '";
    text += given;
    text += "'";
    return text;
}

bool is_whole(const sim::Body& body)
{
    return body.identity().parent == 0;
}

}  // namespace

double ShatterScene::gravity() const
{
    return kShatterGravity;
}

double ShatterScene::least_impact() const
{
    return kLeastImpact;
}

sim::Breaking ShatterScene::breaking() const
{
    sim::Breaking how;
    how.pattern = settings_.pattern;
    how.cells = settings_.cells;
    how.strength = settings_.strength;
    return how;
}

void ShatterScene::tick(sim::Simulation& simulation)
{
    const bool has_whole = std::ranges::any_of(simulation.bodies(), [](const auto& body) { return is_whole(*body); });
    if (simulation.bodies().empty() || (!has_whole && simulation.now() >= next_throw_)) throw_next(simulation);
}

void ShatterScene::throw_next(sim::Simulation& simulation)
{
    const std::size_t model = next_model_;
    next_model_ = (next_model_ + 1) % simulation.models().size();
    simulation.throw_object({model, simulation.seed_for(throws_++), kShatterRadius});
    next_throw_ = simulation.now() + kPause;
}

void ShatterScene::on_press(sim::Simulation& simulation, const glm::dvec2& place)
{
    constexpr double kReach = 3.0;  // beyond the stage, times its distance from the eye
    const glm::dvec3 eye = sim::Camera::eye();
    const glm::dvec3 along = glm::normalize(glm::dvec3(place, 0.0) - eye);
    const std::optional<sim::RayHit> hit =
        simulation.world().first_on_ray(eye, eye + kReach * sim::kEyeDistance * along);
    if (!hit) return;
    const sim::Body& body = *simulation.world().find(hit->object);
    const glm::dvec3 impulse = kBlow * along;
    sim::Breaking how = breaking();
    if (body.cluster() != nullptr) return simulation.strike(hit->object, {hit->place, impulse}, how);
    if (!is_whole(body)) {
        if (body.radius() < kSmallestToBreak) return simulation.push_object(hit->object, {hit->place, impulse});
        how.cells = std::min(settings_.cells, kCellsOfPiece);
    }
    simulation.strike(hit->object, {eye, impulse, along}, how);
}

std::optional<sim::Breaking> ShatterScene::crashes(const sim::Body& body, double impulse) const
{
    return is_whole(body) && impulse >= kCrash ? std::optional(breaking()) : std::nullopt;
}

void ShatterScene::on_broken(sim::Simulation& simulation, const sim::BreakRecord&)
{
    next_throw_ = simulation.now() + kPause;
}

bool ShatterScene::command(sim::Simulation& simulation, std::string_view verb, std::string_view argument)
{
    if (verb == "repeat") {
        if (simulation.last_throw()) simulation.throw_object(*simulation.last_throw());
    } else if (verb == "throw") {
        const sim::ModelLibrary& models = simulation.models();
        std::size_t wanted = argument.empty() ? next_model_ : 0;
        while (!argument.empty() && wanted < models.size() && models.model(wanted).name != argument) ++wanted;
        if (wanted == models.size()) {
            simulation.report(refusal("there are other models", argument));
            return true;
        }
        next_model_ = wanted;
        throw_next(simulation);
    } else if (verb == "cells") {
        if (!parse(argument, ShatterSettings::kFewestCells, ShatterSettings::kMostCells, settings_.cells))
            simulation.report(refusal("an object has 2 to 300 cells", argument));
    } else if (verb == "strength") {
        if (!parse(argument, 0.0, ShatterSettings::kMostStrength, settings_.strength))
            simulation.report(refusal("strengths are 0 to 5000 N s for a square metre", argument));
    } else if (verb == "pattern") {
        const auto found = std::ranges::find(kPatternNames, argument);
        if (found == kPatternNames.end())
            simulation.report(refusal("patterns are uniform, impact, crack, grid and splinters", argument));
        else
            settings_.pattern = static_cast<FracturePattern>(found - kPatternNames.begin());
    } else {
        return false;
    }
    return true;
}

void ShatterScene::hash(sim::StateHash& hash) const
{
    hash.add(settings_.cells);
    hash.add(std::uint64_t(settings_.pattern));
    hash.add(settings_.strength);
    hash.add(std::uint64_t(next_model_));
    hash.add(throws_);
    hash.add(next_throw_);
}

const ShatterScene* shatter_of(const sim::Scene& scene)
{
    return dynamic_cast<const ShatterScene*>(&scene);
}

}  // namespace kerf::game
