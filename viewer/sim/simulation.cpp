#include "viewer/sim/simulation.h"

#include <kerf/section.h>

#include <algorithm>
#include <charconv>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <set>
#include <stdexcept>

#include "common/support/cpu_stopwatch.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/blade_probe.h"
#include "viewer/sim/body_proxies.h"
#include "viewer/sim/breaking/break_body.h"
#include "viewer/sim/crowd.h"
#include "viewer/sim/cut_body.h"
#include "viewer/sim/kerf_glm.h"

namespace kerf::sim {

namespace {

std::unique_ptr<Scene> scene_to_play(const ModelLibrary* models, const std::string& name, std::unique_ptr<Scene> given)
{
    if (models == nullptr || (!given && models->empty())) throw std::invalid_argument("there is no model to throw");
    std::unique_ptr<Scene> scene = given ? std::move(given) : make_scene(name);
    if (!scene) throw std::invalid_argument("there is no scene '" + name + "'");
    return scene;
}

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

std::string what_is_left_out(const CutRecord& cut)
{
    const std::string crowded = "those where " + std::to_string(kMostNeighbours) + " others are already";
    if (cut.crowded == 0) return "the smallest";
    return cut.crowded == cut.dropped ? crowded : "the smallest and " + crowded;
}

}  // namespace

Simulation::Simulation(std::shared_ptr<ModelLibrary> models, Settings settings, std::unique_ptr<Scene> scene)
    : models_(std::move(models)),
      settings_(std::move(settings)),
      scene_(scene_to_play(models_.get(), settings_.scene, std::move(scene))),
      world_(scene_->gravity()),
      proxy_(settings_.proxy),
      input_(settings_.record)
{
    settings_.scene = scene_->name();
    backend_ = settings_.backend.empty() ? backend_names().front() : known_back_end(settings_.backend);
    if (backend_.empty()) throw std::invalid_argument("there is no back end '" + settings_.backend + "'");
    settings_.backend = backend_;
    blade_.set_gesture(settings_.gesture);
}

Simulation::~Simulation() = default;

void Simulation::push(InputEvent event)
{
    event.time = std::max(event.time, time() + 1);
    input_.push(std::move(event));
}

void Simulation::push(const std::vector<InputEvent>& events)
{
    for (const InputEvent& event : events) push(event);
}

void Simulation::command(const std::string& text)
{
    push(InputEvent{time() + 1, InputKind::command, {}, text});
}

/// Of a command that the next tick carries out.
std::string_view Simulation::waiting_argument(std::string_view verb) const
{
    return input_.argument_of(verb, now() + 1);
}

std::string Simulation::backend_to_come() const
{
    const std::string wanted = known_back_end(waiting_argument("backend"));
    return wanted.empty() ? backend_ : wanted;
}

ProxyKind Simulation::proxy_to_come() const
{
    return find_proxy(waiting_argument("proxy")).value_or(proxy_);
}

Gesture Simulation::gesture_to_come() const
{
    const std::string_view wanted = waiting_argument("gesture");
    for (const Gesture gesture : {Gesture::blade, Gesture::segment})
        if (wanted == name_of(gesture)) return gesture;
    return blade_.gesture();
}

std::string Simulation::take_message()
{
    return std::exchange(message_, {});
}

void Simulation::advance(Tick ticks)
{
    for (Tick i = 0; i < ticks; ++i) {
        world_.step();
        had_contact_ = had_contact_ || world_.contacts() > 0;
        for (const std::unique_ptr<Body>& gone : world_.remove_gone()) {
            std::erase_if(pending_, [&](const PendingBreak& one) { return one.object == gone->id(); });
            scene_->on_gone(*this, *gone);
        }
        take_impacts();
        settle_breaks();
        scene_->tick(*this);
        take_input();
    }
}

void Simulation::take_input()
{
    while (const std::optional<InputEvent> event = input_.take(now())) carry_out(*event);
}

void Simulation::carry_out(const InputEvent& event)
{
    std::optional<BladeSegment> segment;
    switch (event.kind) {
        case InputKind::press:
            if (scene_->takes_presses()) return scene_->on_press(*this, event.position);
            blade_.press(event.time, event.position);
            break;
        case InputKind::move:
            if (scene_->takes_presses()) return;
            segment = blade_.move(event.time, event.position);
            break;
        case InputKind::release:
            if (scene_->takes_presses()) return;
            segment = blade_.release(event.time, event.position);
            break;
        case InputKind::command:
            apply_command(event.text);
            break;
    }
    if (segment) swing(*segment);
}

void Simulation::apply_command(const std::string& text)
{
    const std::string_view whole(text);
    const std::size_t space = std::min(whole.find(' '), whole.size());
    const std::string_view verb = whole.substr(0, space);
    const std::size_t begin = std::min(whole.find_first_not_of(' ', space), whole.size());
    const std::string_view argument = whole.substr(begin);

    if (verb == "backend") {
        const std::string wanted = known_back_end(argument);
        if (wanted.empty()) return report("there is no back end '" + std::string(argument) + "'");
        backend_ = wanted;
    } else if (verb == "proxy") {
        const std::optional<ProxyKind> kind = find_proxy(argument);
        if (!kind) return report("there is no collision proxy '" + std::string(argument) + "'");
        proxy_ = *kind;
    } else if (verb == "gesture") {
        if (argument == name_of(Gesture::blade)) {
            blade_.set_gesture(Gesture::blade);
        } else if (argument == name_of(Gesture::segment)) {
            blade_.set_gesture(Gesture::segment);
        } else {
            report("there is no gesture '" + std::string(argument) + "'");
        }
    } else if (verb == "break") {
        ObjectId id = 0;
        const char* const end = argument.data() + argument.size();
        if (const auto parsed = std::from_chars(argument.data(), end, id);
            parsed.ec != std::errc() || parsed.ptr != end)
            return report("there is no object '" + std::string(argument) + "' to break");
        finish_break(id);
    } else if (!scene_->command(*this, verb, argument)) {
        report("there is no command '" + std::string(verb) + "' in scene " + std::string(scene_->name()));
    }
}

void Simulation::swing(const BladeSegment& segment)
{
    const std::optional<WorldPlane> plane = swipe_plane(Camera::eye(), segment.base, segment.to);
    if (!plane) return;
    // Pieces that this segment makes belong to its swipe already, so the objects of this moment are all there is.
    std::vector<ObjectId> hit;
    for (const std::unique_ptr<Body>& body : bodies()) {
        if (body->identity().last_swipe == segment.swipe) continue;
        if (blade_hits(Camera::eye(), segment.from, segment.to, *body)) hit.push_back(body->id());
    }
    for (const ObjectId id : hit) {
        Body* const body = world_.find(id);
        if (body == nullptr || body->object().is_empty()) continue;
        if (const std::optional<Breaking> how = scene_->smashes(*body))
            smash(*body, segment, *plane, *how);
        else
            cut(*body, *plane, segment.swipe);
    }
}

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
            for (BrokenPiece& piece : one.job->pieces) waiting.push_back({&piece.object, piece.key});
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

void Simulation::cut(Body& body, const WorldPlane& plane, std::uint32_t swipe)
{
    CutRecord record;
    record.number = cuts_.size() + 1;
    record.tick = now();
    record.swipe = swipe;
    record.contact_before = had_contact_;
    const bool missed_before = body.missed_swipe() == swipe;
    cut_body(world_, body.id(), plane, {proxy_, settings_.hash_surfaces, &last_id_}, record);
    check_cpu_ms_ += record.check_cpu_ms;
    const bool is_cut = record.status == Status::done || record.status == Status::open_section;
    // A swipe grazes a proxy with segment after segment: one line in the log is enough.
    if (!is_cut && missed_before) return;
    if (record.dropped > 0)
        report("a cut made " + std::to_string(record.pieces.size() + record.dropped) + " pieces: there is room for " +
               std::to_string(record.pieces.size()) + "; left out are " + what_is_left_out(record));
    cuts_.push_back(std::move(record));
    scene_->on_cut(*this, cuts_.back());
}

std::uint64_t Simulation::seed_for(std::uint64_t n) const
{
    StateHash hash;
    hash.add(settings_.seed);
    hash.add(n);
    return hash.value();
}

const Body* Simulation::throw_object(const Throw& what)
{
    const Flight flight = plan_flight(what.seed, world_.gravity(), what.radius);
    const Box& box = models_->model(what.model).box;
    const double radius = radius_of(box);
    const double scale = radius > 0.0 ? what.radius / radius : 1.0;
    const Body* const body = place_object(what.model, scale, flight.centre, flight.rotation, flight.motion);
    if (body != nullptr) last_throw_ = what;
    return body;
}

const Body* Simulation::place_object(std::size_t model, double scale, const glm::dvec3& centre,
                                     const glm::dmat3& rotation, const Motion& motion)
{
    if (bodies().size() >= kMostBodies) {
        report("there are " + std::to_string(bodies().size()) + " pieces in the air: no room for another throw");
        return nullptr;
    }
    const Box& box = models_->model(model).box;
    MeshPose pose;
    pose.scale = scale;
    pose.rotation = rotation;
    pose.translation = centre - scale * (rotation * centre_of(box));
    if (bodies().size() >= kMostNeighbours && Crowd(world_).is_thick_at(world_box(box, pose))) {
        report("there are " + std::to_string(kMostNeighbours) +
               " pieces or more where a throw begins: no room for another one before they are gone");
        return nullptr;
    }
    Throwable taken = models_->take(model, backend_, proxy_);
    if (!taken.object) {
        report(models_->prepare(model, backend_));
        return nullptr;
    }
    Identity identity;
    identity.id = ++last_id_;
    identity.birth = now();
    identity.origin.throw_number = ++throws_;
    identity.origin.model = model;
    identity.origin.copy = taken.copy;
    identity.origin.backend = backend_;
    identity.origin.scale = scale;
    identity.origin.centre = centre_of(box);
    identity.origin.radius = radius_of(box);

    const Solid solid = solid_of(taken.mass, taken.bounds, scale);
    return &world_.add(
        std::make_unique<Body>(std::move(identity), std::move(taken.object), solid, pose, motion, *taken.proxy));
}

const Body* Simulation::let_enter(std::size_t model, double scale, const glm::dvec3& centre, const glm::dmat3& rotation,
                                  const Motion& motion)
{
    const Body* const placed = place_object(model, scale, centre, rotation, motion);
    if (placed != nullptr) world_.find(placed->id())->set_entering(true);
    return placed;
}

bool Simulation::move_object(ObjectId id, const Motion& motion)
{
    Body* const body = world_.find(id);
    if (body != nullptr) body->set_motion(motion);
    return body != nullptr;
}

void Simulation::push_object(ObjectId id, const Blow& blow)
{
    Body* const body = world_.find(id);
    if (body == nullptr) return;
    if (Cluster* const cluster = body->cluster())
        cluster->push(blow.place, blow.impulse);
    else
        body->push(blow.place, blow.impulse);
}

std::uint64_t Simulation::state_hash() const
{
    StateHash hash;
    hash.add(now());
    hash.add(last_id_);
    hash.add(throws_);
    for (const std::unique_ptr<Body>& body : bodies()) body->hash(hash);
    blade_.hash(hash);
    input_.hash(hash);
    hash.add(std::string_view(backend_));
    hash.add(std::uint64_t(proxy_));
    world_.hash(hash);
    for (const PendingBreak& one : pending_) {
        hash.add(one.object);
        hash.add(one.struck);
        hash.add(one.impulse);
    }
    hash.add(partings_);
    scene_->hash(hash);
    return hash.value();
}

Script Simulation::recording() const
{
    Script script;
    script.scene = settings_.scene;
    script.backend = settings_.backend;
    script.proxy = proxy_name(settings_.proxy);
    script.seed = settings_.seed;
    if (settings_.gesture != Gesture::blade)
        script.events.push_back({1, InputKind::command, {}, "gesture " + std::string(name_of(settings_.gesture))});
    script.events.insert(script.events.end(), input_.recorded().begin(), input_.recorded().end());
    return script;
}

}  // namespace kerf::sim
