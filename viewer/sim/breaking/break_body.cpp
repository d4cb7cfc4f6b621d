#include "viewer/sim/breaking/break_body.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "viewer/sim/breaking/bond_loads.h"
#include "viewer/sim/breaking/scatter.h"
#include "viewer/sim/piece_choice.h"

namespace kerf::sim {
namespace {

/// Lets parts that bonds hold together no longer fly apart.
void fly_apart(const std::vector<std::vector<Body*>>& parts, double speed)
{
    std::vector<ScatteredPart> scattered;
    for (const std::vector<Body*>& part : parts) {
        const Body& first = *part.front();
        if (const Cluster* const cluster = first.cluster())
            scattered.push_back({cluster->mass(), cluster->centre(), cluster->motion()});
        else
            scattered.push_back({first.mass(), first.centre(), first.motion()});
    }
    scatter(scattered, speed);
    for (std::size_t i = 0; i < parts.size(); ++i) {
        Body& first = *parts[i].front();
        if (Cluster* const cluster = first.cluster()) {
            cluster->set_motion(scattered[i].motion);
            cluster->carry();
        } else {
            first.set_motion(scattered[i].motion);
        }
    }
}

void make_siblings(std::span<Body* const> bodies, std::uint64_t number, Tick now)
{
    for (Body* const body : bodies) body->add_recent_cut({number, now + kBreakSiblingTicks}, now);
}

/// The bonds of a cluster that a blow leaves.
std::vector<Bond> bonds_left(const Cluster& cluster, const glm::dvec3& place, double impulse)
{
    std::vector<LoadedPart> parts;
    std::map<ObjectId, std::uint32_t> number;
    for (const Body* const body : cluster.members()) {
        number[body->id()] = std::uint32_t(parts.size());
        parts.push_back({body->mass(), body->centre()});
    }
    std::vector<LoadedBond> bonds;
    for (const Bond& bond : cluster.bonds())
        bonds.push_back({number.at(bond.first), number.at(bond.second), bond.strength});
    const std::vector<bool> is_broken = broken_bonds(parts, bonds, place, impulse);
    std::vector<Bond> left;
    for (std::size_t i = 0; i < bonds.size(); ++i)
        if (!is_broken[i]) left.push_back(cluster.bonds()[i]);
    return left;
}

}  // namespace

CrackRecord crack(World& world, Cluster& cluster, const Blow& blow, double speed, std::uint64_t number)
{
    CrackRecord record;
    record.tick = world.now();
    record.model = cluster.members().front()->identity().origin.model;
    record.place = blow.place;
    record.impulse = glm::length(blow.impulse);
    record.radius = cluster.radius();
    if (blow.pushes) {
        cluster.push(blow.place, blow.impulse);
        cluster.carry();
    }
    const std::vector<Bond> left = bonds_left(cluster, blow.place, record.impulse);
    record.bonds = cluster.bonds().size() - left.size();
    record.parts = 1;
    if (record.bonds == 0) return record;
    make_siblings(cluster.members(), number, world.now());
    const std::vector<std::vector<Body*>> parts = world.part(cluster, left);
    record.parts = parts.size();
    fly_apart(parts, speed);
    return record;
}

CrackRecord break_body(World& world, ObjectId id, BreakJob& job, const BreakBodyOptions& options, BreakRecord& record)
{
    Body& body = *world.find(id);
    const MeshPose pose = body.pose();
    record.place = pose.to_world(job.at);
    record.centre = body.centre();
    record.radius = body.radius();
    const Breaking& how = options.how;
    const bool holds = how.strength > 0.0 && !job.bonds.empty();
    // A whole that its bonds hold is pushed by crack(), which sees to them.
    if (!holds && options.pushes) body.push(record.place, options.impulse);
    const Motion motion = body.motion();
    const std::unique_ptr<Body> parent = world.remove(id);

    std::vector<Candidate> candidates;
    for (const BrokenPiece& piece : job.pieces) candidates.push_back({piece.solid.mass, world_box(piece.box, pose)});
    const PieceChoice choice = choose_heaviest(candidates, world, kMostNeighboursOfBreak);
    std::vector<Body*> bodies, of_piece(job.pieces.size(), nullptr);
    for (std::size_t i = 0; i < job.pieces.size(); ++i) {
        BrokenPiece& piece = job.pieces[i];
        if (!choice.stays[i]) {
            ++record.dropped;
            continue;
        }
        const glm::dvec3 arm = pose.to_world(piece.solid.centre) - record.centre;
        const Motion inherited{motion.velocity + glm::cross(motion.spin, arm), motion.spin};
        Identity identity = heir_of(parent->identity(), ++*options.last_id, record.tick, options.swipe,
                                    {options.number, record.tick + kBreakSiblingTicks});
        identity.origin.copy = piece.key;
        Body& made = world.add(std::make_unique<Body>(std::move(identity), std::move(piece.object), piece.solid, pose,
                                                      inherited, std::move(piece.proxy)));
        bodies.push_back(of_piece[i] = &made);
        record.pieces.push_back(made.id());
    }

    std::vector<Bond> bonds;
    for (const FractureBond& bond : job.bonds) {
        const Body *const first = of_piece[bond.first], *const second = of_piece[bond.second];
        if (first == nullptr || second == nullptr) continue;
        ++record.bonds;
        bonds.push_back({first->id(), second->id(), how.strength * bond.area * pose.scale * pose.scale});
    }
    CrackRecord cracks;
    cracks.tick = record.tick;
    cracks.model = record.model;
    cracks.place = record.place;
    cracks.impulse = glm::length(options.impulse);
    cracks.radius = record.radius;
    if (!holds) {
        std::vector<std::vector<Body*>> parts;
        for (Body* const one : bodies) parts.push_back({one});
        fly_apart(parts, how.speed);
        cracks.bonds = bonds.size();
        cracks.parts = parts.size();
        return cracks;
    }
    const auto nearest = std::min_element(bodies.begin(), bodies.end(), [&](const Body* a, const Body* b) {
        return glm::distance(a->centre(), record.place) < glm::distance(b->centre(), record.place);
    });
    const std::size_t parts = world.bind(bodies, bonds).size();
    cracks.parts = parts;
    if (nearest == bodies.end()) return cracks;
    if (Cluster* const cluster = (*nearest)->cluster()) {
        const Blow blow{record.place, options.impulse, {}, options.pushes};
        const CrackRecord first = crack(world, *cluster, blow, how.speed, options.number);
        cracks.bonds = first.bonds;
        cracks.parts = parts - 1 + first.parts;
    } else if (options.pushes) {
        (*nearest)->push(record.place, options.impulse);
    }
    return cracks;
}

}  // namespace kerf::sim
