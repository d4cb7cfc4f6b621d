#include "viewer/game/games.h"

#include <cmath>

#include "common/shapes/shapes.h"
#include "support/public_mesh.h"
#include "viewer/game/fruit_models.h"
#include "viewer/sim/camera.h"

namespace kerf::test {
namespace {

Mesh stretched(core::TriangleSoup soup, const glm::vec3& stretch)
{
    for (core::Vertex& vertex : soup.vertices) vertex.position *= stretch;
    return mesh_of(soup);
}

Mesh stand_in(game::FruitKind kind)
{
    using enum game::FruitKind;
    switch (kind) {
        case coconut:
            return mesh_of(core::shapes::sphere_in_sphere(1.0f, 0.75f, 4));
        case lemon:
            return stretched(core::shapes::icosphere(1.0f, 4), {1.0f, 1.0f, 1.25f});
        case banana:
        case freeze:
        case frenzy:
        case double_points:
        case hammer:
            return stretched(core::shapes::icosphere(1.0f, 4), {0.3f, 0.3f, 1.0f});
        case pineapple:
            return stretched(core::shapes::icosphere(1.0f, 4), {0.5f, 0.5f, 1.0f});
        default:
            return mesh_of(core::shapes::icosphere(1.0f, 4));
    }
}

/// Where a body is seen after the next tick, which takes the input in.
glm::dvec2 aim(const sim::Body& body)
{
    return sim::Camera::seen_on_stage(body.centre() + sim::kTickSeconds * body.motion().velocity);
}

}  // namespace

std::shared_ptr<sim::ModelLibrary> fruit_library()
{
    auto library = std::make_shared<sim::ModelLibrary>();
    for (const game::Fruit& fruit : game::fruit_catalogue())
        library->add(std::string(fruit.model), stand_in(fruit.kind));
    return library;
}

std::shared_ptr<sim::ModelLibrary> real_fruit()
{
    static const auto library = [] {
        auto models = std::make_shared<sim::ModelLibrary>();
        game::add_fruit_models(*models, KERF_FRUIT_DIR);
        return models;
    }();
    return library;
}

Game::Game(game::GameMode mode, std::uint64_t seed, const std::string& backend,
           const std::shared_ptr<sim::ModelLibrary>& models)
{
    sim::Settings settings;
    settings.seed = seed;
    settings.backend = backend;
    settings.record = true;
    simulation_ = std::make_unique<sim::Simulation>(models, settings, std::make_unique<game::GameScene>(mode, *models));
}

std::vector<game::GameEvent> Game::events(game::GameEventKind kind) const
{
    std::vector<game::GameEvent> found;
    for (const game::GameEvent& event : scene().events())
        if (event.kind == kind) found.push_back(event);
    return found;
}

bool Game::is_well_inside(const sim::Body& body) const
{
    const glm::dvec2 place = sim::Camera::seen_on_stage(body.centre());
    return std::abs(place.x) < 0.9 * sim::kStageHalfWidth && std::abs(place.y) < 0.8 * sim::kStageHalfHeight;
}

const sim::Body* Game::find_fruit() const
{
    for (const auto& body : simulation_->bodies()) {
        const std::optional<game::FruitKind> kind = scene().whole(body->id());
        if (kind && *kind != game::FruitKind::bomb && is_well_inside(*body)) return body.get();
    }
    return nullptr;
}

const sim::Body* Game::find(game::FruitKind kind) const
{
    for (const auto& body : simulation_->bodies())
        if (scene().whole(body->id()) == kind && is_well_inside(*body)) return body.get();
    return nullptr;
}

void Game::push(sim::InputKind kind, const glm::dvec2& place)
{
    next_ = std::max(next_ + 1, simulation_->time() + 1);
    simulation_->push({next_, kind, place, {}});
    pointer_ = place;
}

void Game::swipe_through(const sim::Body& body, double beside)
{
    const glm::dvec2 middle = aim(body) + glm::dvec2(0.0, beside);
    push(sim::InputKind::press, middle - glm::dvec2(2.0, 0.0));
    push(sim::InputKind::release, middle + glm::dvec2(2.0, 0.0));
    simulation_->advance();
}

void Game::press(const glm::dvec2& place)
{
    push(sim::InputKind::press, place);
}

void Game::sweep_through(const sim::Body& body)
{
    const glm::dvec2 middle = aim(body);
    push(sim::InputKind::move, middle + (middle - pointer_));
    simulation_->advance();
}

void Game::release()
{
    push(sim::InputKind::release, pointer_);
    simulation_->advance();
}

}  // namespace kerf::test
