// What breaks in a simulation: blows, impacts, and objects that are being taken apart.

#include <kerf/section.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <set>

#include "common/support/cpu_stopwatch.h"
#include "viewer/sim/breaking/break_body.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/sim/simulation.h"

namespace kerf::sim {

namespace {

/// Numbers of breaks among those of cuts (RecentCut): no run has so many cuts.
constexpr std::uint64_t kFirstBreak = std::uint64_t(1) << 32;

glm::dvec3 to_mesh(const MeshPose& pose, const glm::dvec3& place)
{
    return glm::transpose(pose.rotation) * (place - pose.translation) / pose.scale;
}

/// Along the longest side of its box: the grain of splinters.
Normal grain_of(const Box& box)
{
    const glm::dvec3 side = extent_of(box);
    const bool is_high = side.y >= side.x && side.y >= side.z;
    return is_high ? Normal(0, 1, 0) : side.x >= side.z ? Normal(1, 0, 0) : Normal(0, 0, 1);
}

/// Nothing of it is left to do on the graphics card.
bool is_uploaded(const Object& object, DrawView& view)
{
    return ok(object.draw(view)) && view.new_vertices_from == view.vertices.size() &&
           view.new_indices_from == view.indices.size();
}

}  // namespace

/// What the blade goes through is struck where the blade meets it; what it only brushes is not.
void Simulation::smash(Body& body, const BladeSegment& segment, const WorldPlane& plane, const Breaking& how)
{
    if (body.missed_swipe() == segment.swipe) return;
    const std::optional<Plane> across = object_plane(plane, body.pose(), body.identity().origin);
    Section met;
    if (!across || !ok(section(body.object(), *across, met)) || met.path_count() == 0)
        return body.mark_missed(segment.swipe);
    // The point of the line of sight through the segment's end that is nearest to the middle of the body.
    const glm::dvec3 eye = Camera::eye();
    const glm::dvec3 along = glm::normalize(glm::dvec3(0.5 * (segment.from + segment.to), 0.0) - eye);
    const glm::dvec3 place = eye + glm::dot(body.centre() - eye, along) * along;
    const glm::dvec2 stroke = segment.to - segment.base;
    const double length = glm::length(stroke);
    const glm::dvec3 direction = length > 0.0 ? glm::dvec3(stroke / length, 0.0) : glm::dvec3(0.0);
    strike(body.id(), {place, kBladeBlow * body.mass() * direction, {}}, how, segment.swipe);
    scene_->on_smashed(*this, body, segment.swipe);
}

void Simulation::strike(ObjectId id, const Blow& blow, const Breaking& how, std::uint32_t swipe)
{
    Body* const body = world_.find(id);
    if (body == nullptr || body->object().is_empty()) return;
    if (Cluster* const cluster = body->cluster()) return crack(*cluster, blow, how.speed);
    const MeshPose pose = body->pose();
    auto job = std::make_shared<BreakJob>();
    job->options.pattern = how.pattern;
    job->options.cells = how.cells;
    StateHash seed;
    seed.add(settings_.seed);
    seed.add(id);
    seed.add(now());
    job->options.seed = seed.value();
    if (how.pattern == FracturePattern::splinters) job->options.direction = grain_of(body->object().bounds());
    const glm::dvec3 at = to_mesh(pose, blow.place);
    if (blow.along == glm::dvec3(0.0))
        job->options.at = Point(at.x, at.y, at.z);
    else
        job->ray = MeshRay{at, glm::transpose(pose.rotation) * blow.along};
    job->scale = pose.scale;
    job->proxy = proxy_;
    job->triangles = body->object().triangle_count();
    job->object = body->take_object();
    pending_.push_back({id, now(), how, blow.impulse, blow.pushes, swipe, job, false});
    breaker_.start(std::move(job));
}

void Simulation::crack(Cluster& cluster, const Blow& blow, double speed)
{
    CrackRecord record = sim::crack(world_, cluster, blow, speed, kFirstBreak + partings_++);
    // What a collision leaves whole is nothing that happened.
    if (record.bonds > 0 || blow.pushes) cracks_.push_back(record);
}

/// What bodies that touched dealt one another.
void Simulation::take_impacts()
{
    if (world_.contacts() == 0) return;
    std::set<ObjectId> struck;  // members of clusters that fell apart just now
    for (const Impact& impact : world_.impacts(scene_->least_impact())) {
        Body* const body = world_.find(impact.object);
        if (body == nullptr || body->object().is_empty() || struck.contains(impact.object)) continue;
        // The engine has moved it already.
        const Blow blow{impact.place, impact.impulse, {}, false};
        if (Cluster* const cluster = body->cluster()) {
            for (const Body* const member : cluster->members()) struck.insert(member->id());
            crack(*cluster, blow, kCollisionParting);
        } else if (const auto how = scene_->crashes(*body, glm::length(impact.impulse))) {
            strike(impact.object, blow, *how);
        }
    }
}

bool Simulation::is_breaking(ObjectId id) const
{
    return std::any_of(pending_.begin(), pending_.end(), [&](const PendingBreak& one) { return one.object == id; });
}

std::vector<WaitingPiece> Simulation::waiting_pieces() const
{
    std::vector<WaitingPiece> waiting;
    for (const PendingBreak& one : pending_)
        if (one.job->is_done)
            for (BrokenPiece& piece : one.job->pieces) waiting.push_back({&piece.object, piece.key, one.object});
    return waiting;
}

void Simulation::settle_breaks()
{
    if (settings_.breaks == Readiness::at_once) {
        while (!pending_.empty()) finish_break(pending_.front().object);
        return;
    }
    if (settings_.breaks == Readiness::on_command) return;
    DrawView view;
    for (PendingBreak& one : pending_) {
        if (one.is_announced || !one.job->is_done) continue;
        one.is_announced = std::all_of(one.job->pieces.begin(), one.job->pieces.end(),
                                       [&](const BrokenPiece& piece) { return is_uploaded(piece.object, view); });
        if (one.is_announced) command("break " + std::to_string(one.object));
    }
}

/// Waits for the thread, if it is not done.
void Simulation::finish_break(ObjectId id)
{
    const auto found =
        std::find_if(pending_.begin(), pending_.end(), [&](const PendingBreak& one) { return one.object == id; });
    if (found == pending_.end()) return;
    const PendingBreak pending = std::move(*found);
    pending_.erase(found);
    BreakJob& job = *pending.job;
    job.wait();
    core::CpuStopwatch cpu;
    Body& body = *world_.find(id);
    BreakRecord record;
    record.number = breaks_.size() + 1;
    record.struck = pending.struck;
    record.tick = now();
    record.object = id;
    record.model = body.identity().origin.model;
    record.backend = body.identity().origin.backend;
    record.status = job.status;
    record.fracture_ms = job.fracture_ms;
    record.proxy_ms = job.proxy_ms;
    if (ok(job.status)) {
        record.triangles = job.triangles;
        const BreakBodyOptions options{pending.how,   pending.impulse, pending.pushes, kFirstBreak + partings_++,
                                       pending.swipe, &last_id_};
        cracks_.push_back(break_body(world_, id, job, options, record));
    } else {
        record.place = record.centre = body.centre();
        body.put_back(std::move(job.object));
        if (pending.swipe != 0) body.mark_missed(pending.swipe);
        if (!job.reason.empty()) report("this can't be broken: " + job.reason);
    }
    record.cpu_ms = 1e3 * cpu.lap();
    breaks_.push_back(std::move(record));
    scene_->on_broken(*this, breaks_.back());
}

}  // namespace kerf::sim
