#include "viewer/sim/simulation.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "viewer/sim/back_ends.h"
#include "viewer/sim/blade_probe.h"
#include "viewer/sim/body_proxies.h"
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
