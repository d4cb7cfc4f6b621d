#include "viewer/game/giant_scene.h"

#include <algorithm>
#include <charconv>
#include <glm/geometric.hpp>

#include "viewer/sim/kerf_glm.h"
#include "viewer/sim/simulation.h"

namespace kerf::game {
namespace {

/// What was cut off sinks slowly out of the picture, m/s^2.
constexpr double kGravity = 5.0;
/// Half the diagonal of its box, metres: nearly as high as the stage.
constexpr double kRadius = 5.0;
/// From where it rises: below the stage, but not so far that a window in any shape would show it waiting.
constexpr double kStartsAt = -(sim::kStageHalfHeight + kRadius);
/// The held piece goes to the middle at this part of its distance in a second, but no faster than so many m/s.
constexpr double kPull = 2.5, kFastest = 8.0;
/// It turns about this axis, rad/s; what a cut made it turn dies away by this part in a second.
constexpr glm::dvec3 kSpin{0.06, 0.38, 0.10};
constexpr double kSpinCalms = 2.0;
/// When less of it is left the next one comes.
constexpr double kLeftOver = 0.02;

}  // namespace

GiantScene::GiantScene(std::shared_ptr<sim::ModelLibrary> models, sim::Readiness readiness)
    : maker_(std::move(models)), readiness_(readiness)
{
}

double GiantScene::gravity() const
{
    return kGravity;
}

void GiantScene::tick(sim::Simulation& simulation)
{
    // Not in the first tick: a size that is asked for at the start comes with it.
    if (simulation.now() > 1 && (is_wanted_ || backend_ != simulation.backend())) request(simulation);
    if (is_expected_ && readiness_ == sim::Readiness::at_once) show(simulation);
    if (is_expected_ && readiness_ == sim::Readiness::when_ready && !is_announced_ && may_show(simulation)) {
        is_announced_ = true;
        simulation.command("show");
    }
    hold(simulation);
}

void GiantScene::request(sim::Simulation& simulation)
{
    backend_ = simulation.backend();
    maker_.request(triangles_, simulation.settings().seed, backend_, simulation.proxy());
    is_wanted_ = false;
    is_expected_ = true;
    is_announced_ = false;
}

/// It failed, or it is there and on the graphics card.
bool GiantScene::may_show(const sim::Simulation& simulation) const
{
    if (maker_.stage() != GiantStage::ready) return maker_.is_done();
    const std::optional<sim::StockedCopy> copy = simulation.models().stocked(maker_.model(), backend_);
    if (!copy) return false;
    DrawView view;
    return ok(copy->object->draw(view)) && view.new_vertices_from == view.vertices.size() &&
           view.new_indices_from == view.indices.size();
}

void GiantScene::show(sim::Simulation& simulation)
{
    is_expected_ = false;
    maker_.wait();
    if (maker_.stage() == GiantStage::failed) return simulation.report(maker_.error());
    const Box& box = simulation.models().model(maker_.model()).box;
    const double reach = sim::radius_of(box);
    const sim::Motion rising{{0.0, kFastest, 0.0}, kSpin};
    const sim::Body* const body =
        simulation.place_object(maker_.model(), kRadius / reach, {0.0, kStartsAt, 0.0}, glm::dmat3(1.0), rising);
    if (body == nullptr) return;
    held_ = body->id();
    whole_mass_ = body->mass();
    ++giants_;
}

void GiantScene::hold(sim::Simulation& simulation)
{
    const sim::Body* const body = held_ == 0 ? nullptr : simulation.world().find(held_);
    if (body == nullptr) return;
    sim::Motion motion = body->motion();
    motion.velocity = -kPull * body->centre();
    const double speed = glm::length(motion.velocity);
    if (speed > kFastest) motion.velocity *= kFastest / speed;
    // What the next step adds.
    motion.velocity.y += kGravity * sim::kTickSeconds;
    motion.spin += (kSpin - motion.spin) * (kSpinCalms * sim::kTickSeconds);
    simulation.move_object(held_, motion);
}

void GiantScene::on_cut(sim::Simulation&, const sim::CutRecord& cut)
{
    if (cut.object != held_ || cut.pieces.empty()) return;
    const auto heaviest = std::max_element(cut.pieces.begin(), cut.pieces.end(),
                                           [](const auto& a, const auto& b) { return a.mass < b.mass; });
    held_ = heaviest->id;
    if (heaviest->mass >= kLeftOver * whole_mass_) return;
    held_ = 0;
    is_wanted_ = true;
}

void GiantScene::on_gone(sim::Simulation&, const sim::Body& body)
{
    if (body.id() != held_) return;
    held_ = 0;
    is_wanted_ = true;
}

bool GiantScene::command(sim::Simulation& simulation, std::string_view verb, std::string_view argument)
{
    if (verb == "show") {
        if (is_expected_ && readiness_ != sim::Readiness::at_once) show(simulation);
        return true;
    }
    if (verb == "size") {
        std::int64_t triangles = 0;
        const char* const end = argument.data() + argument.size();
        const auto parsed = std::from_chars(argument.data(), end, triangles);
        if (parsed.ec != std::errc() || parsed.ptr != end || triangles < kFewestGiantTriangles ||
            triangles > kMostGiantTriangles) {
            std::string message = "a giant has ";
            message += std::to_string(kFewestGiantTriangles);
            message += " to ";
            message += std::to_string(kMostGiantTriangles);
            message += " triangles, not '";
            message += argument;
            message += "'";
            simulation.report(message);
            return true;
        }
        if (triangles == triangles_ && is_expected_) return true;
        triangles_ = triangles;
    } else if (verb != "next") {
        return false;
    }
    held_ = 0;
    is_wanted_ = true;
    return true;
}

std::vector<std::size_t> GiantScene::next_models() const
{
    if (!is_expected_ || maker_.stage() != GiantStage::ready) return {};
    return {maker_.model()};
}

void GiantScene::hash(sim::StateHash& hash) const
{
    hash.add(triangles_);
    hash.add(std::string_view(backend_));
    hash.add(is_expected_);
    hash.add(is_wanted_);
    hash.add(held_);
    hash.add(whole_mass_);
    hash.add(giants_);
}

GiantState GiantScene::state() const
{
    return {triangles_, maker_.stage(), maker_.progress(), is_expected_, held_ != 0, giants_};
}

const GiantScene* giant_of(const sim::Scene& scene)
{
    return dynamic_cast<const GiantScene*>(&scene);
}

}  // namespace kerf::game
