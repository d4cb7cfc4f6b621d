#include "viewer/game/game_scene.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "viewer/sim/camera.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/sim/simulation.h"

namespace kerf::game {
namespace {

/// Numbers of decisions for Simulation::seed_for(): waves count from 1, throws of a frenzy from here.
constexpr std::uint64_t kFrenzySeeds = std::uint64_t(1) << 32;

/// What is smashed bursts into so many pieces, the outermost so fast, m/s.
constexpr std::uint32_t kCellsOfFruit = 18;
constexpr double kBurstSpeed = 4.0;

bool is_thrown_in(GameMode mode, FruitKind kind)
{
    if (is_special(kind) || kind == FruitKind::frozen) return mode == GameMode::arcade;
    return kind != FruitKind::bomb || mode != GameMode::zen;
}

std::size_t find_model(const sim::ModelLibrary& models, const Fruit& fruit)
{
    for (std::size_t i = 0; i < models.size(); ++i)
        if (models.model(i).name == fruit.model) return i;
    throw std::invalid_argument("there is no model '" + std::string(fruit.model) + "' to throw");
}

/// Of the mass, on the side of a cut that has less of it.
double lighter_share(const sim::CutRecord& cut)
{
    double sides[2] = {0.0, 0.0};
    for (const sim::PieceRecord& piece : cut.pieces) sides[piece.positive ? 1 : 0] += piece.mass;
    const double whole = sides[0] + sides[1];
    return whole > 0.0 ? std::min(sides[0], sides[1]) / whole : 0.0;
}

/// The nearest place that everybody sees.
glm::dvec2 inside_stage(const glm::dvec2& place)
{
    const glm::dvec2 corner(sim::kStageHalfWidth, sim::kStageHalfHeight);
    return glm::clamp(place, -corner, corner);
}

}  // namespace

GameScene::GameScene(GameMode mode, const sim::ModelLibrary& models, std::int64_t best)
    : mode_(mode), rules_(mode, best)
{
    for (const Fruit& fruit : fruit_catalogue())
        if (is_thrown_in(mode, fruit.kind)) models_[static_cast<std::size_t>(fruit.kind)] = find_model(models, fruit);
}

void GameScene::tick(sim::Simulation& simulation)
{
    rules_.tick(simulation.now(), simulation.blade().swipe(), simulation.blade().pressed());
    if (rules_.is_over()) return;
    if (rules_.is_active(FruitKind::frenzy)) {
        run_frenzy(simulation);
    } else {
        run_waves(simulation);
    }
}

void GameScene::run_frenzy(sim::Simulation& simulation)
{
    if (rules_.age(FruitKind::frenzy) % kFrenzyGap == 0) {
        const std::uint64_t number = frenzy_throws_++;
        throw_fruit(simulation, plan_frenzy_throw(number, simulation.seed_for(kFrenzySeeds + number)));
    }
    // The wave under way waits.
    ++wave_start_;
    ++next_wave_;
}

void GameScene::run_waves(sim::Simulation& simulation)
{
    const sim::Tick now = simulation.now();
    const int number = rules_.state().wave;
    if (next_throw_ == wave_.size()) {
        if (number > 0 && flying_.empty()) next_wave_ = std::min(next_wave_, now + difficulty_of(mode_, number).pause);
        if (now < next_wave_) return;
        rules_.start_wave(now);
        wave_ = plan_wave(mode_, number + 1, simulation.seed_for(std::uint64_t(number) + 1));
        wave_start_ = now;
        next_throw_ = 0;
    }
    while (next_throw_ < wave_.size() && wave_start_ + wave_[next_throw_].after <= now)
        throw_fruit(simulation, wave_[next_throw_++]);
    if (next_throw_ == wave_.size()) next_wave_ = now + difficulty_of(mode_, rules_.state().wave).longest;
}

void GameScene::throw_fruit(sim::Simulation& simulation, const PlannedThrow& what)
{
    const std::size_t model = models_[static_cast<std::size_t>(what.kind)];
    const Box& box = simulation.models().model(model).box;
    const double reach = sim::radius_of(box);
    const double scale = reach > 0.0 ? fruit_of(what.kind).radius / reach : 1.0;
    const sim::Flight& flight = what.flight;
    const sim::Body* const body = simulation.let_enter(model, scale, flight.centre, flight.rotation, flight.motion);
    if (body == nullptr) return;
    flying_[body->id()] = what.kind;
    rules_.thrown(simulation.now(), what.kind, inside_stage(glm::dvec2(flight.centre)), body->id());
}

void GameScene::on_cut(sim::Simulation&, const sim::CutRecord& cut)
{
    if (cut.status != Status::done && cut.status != Status::open_section) return;
    const auto found = flying_.find(cut.object);
    if (found == flying_.end()) return;
    Cut what;
    what.kind = found->second;
    what.tick = cut.tick;
    what.swipe = cut.swipe;
    what.place = inside_stage(sim::Camera::seen_on_stage(cut.centre));
    what.lighter_share = lighter_share(cut);
    what.object = cut.object;
    what.number = cut.number;
    flying_.erase(found);
    rules_.cut(what);
}

std::size_t GameScene::most_pieces() const
{
    return kCellsOfFruit;
}

std::optional<sim::Breaking> GameScene::smashes(const sim::Body& body) const
{
    if (!bursts(body.id())) return std::nullopt;
    sim::Breaking how;
    how.cells = kCellsOfFruit;
    how.speed = kBurstSpeed;
    return how;
}

void GameScene::on_smashed(sim::Simulation& simulation, const sim::Body& body, std::uint32_t swipe)
{
    const auto found = flying_.find(body.id());
    if (found == flying_.end()) return;
    Cut what;
    what.kind = found->second;
    what.tick = simulation.now();
    what.swipe = swipe;
    what.place = inside_stage(sim::Camera::seen_on_stage(body.centre()));
    what.object = body.id();
    flying_.erase(found);
    rules_.cut(what);
}

void GameScene::on_gone(sim::Simulation& simulation, const sim::Body& body)
{
    const auto found = flying_.find(body.id());
    if (found == flying_.end()) return;
    const FruitKind kind = found->second;
    flying_.erase(found);
    rules_.gone(simulation.now(), kind, inside_stage(sim::Camera::seen_on_stage(body.centre())), body.id());
}

bool GameScene::command(sim::Simulation& simulation, std::string_view verb, std::string_view)
{
    if (verb != "over") return false;
    rules_.give_up(simulation.now());
    return true;
}

std::vector<std::size_t> GameScene::next_models() const
{
    std::vector<std::size_t> next;
    const auto add = [&](FruitKind kind) {
        const std::size_t model = models_[static_cast<std::size_t>(kind)];
        if (std::find(next.begin(), next.end(), model) == next.end()) next.push_back(model);
    };
    for (std::size_t i = next_throw_; i < wave_.size(); ++i) add(wave_[i].kind);
    for (const Fruit& fruit : fruit_catalogue())
        if (is_thrown_in(mode_, fruit.kind)) add(fruit.kind);
    return next;
}

void GameScene::hash(sim::StateHash& hash) const
{
    rules_.hash(hash);
    hash.add(std::uint64_t(next_throw_));
    hash.add(wave_start_);
    hash.add(next_wave_);
    hash.add(frenzy_throws_);
    for (const auto& [id, kind] : flying_) {
        hash.add(id);
        hash.add(std::uint64_t(kind));
    }
}

std::optional<FruitKind> GameScene::whole(sim::ObjectId id) const
{
    const auto found = flying_.find(id);
    return found == flying_.end() ? std::nullopt : std::optional(found->second);
}

bool GameScene::bursts(sim::ObjectId id) const
{
    const std::optional<FruitKind> kind = whole(id);
    return kind && rules_.smashes(*kind);
}

const GameScene* game_of(const sim::Scene& scene)
{
    return dynamic_cast<const GameScene*>(&scene);
}

}  // namespace kerf::game
