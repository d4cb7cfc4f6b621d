#include "viewer/sim/cut_body.h"

#include <algorithm>
#include <array>

#include "common/support/cpu_stopwatch.h"
#include "common/support/stopwatch.h"
#include "viewer/sim/cap_area.h"
#include "viewer/sim/parting.h"
#include "viewer/sim/piece_choice.h"
#include "viewer/sim/surface_hash.h"

namespace kerf::sim {
namespace {

constexpr std::size_t kUsualPieces = 2;

struct Piece
{
    Object object;
    Box box;
    bool positive = false;
    Solid solid;
};

void append(std::vector<Piece>& pieces, Cut& cut, Side side)
{
    const auto first = std::ptrdiff_t(pieces.size());
    for (std::size_t i = 0; Object* const object = cut.piece(side, i); ++i) {
        const Box box = object->bounds();
        pieces.push_back({std::move(*object), box, side == Side::positive, {}});
    }
    if (pieces.end() - pieces.begin() - first < 2) return;
    const auto key = [](const Piece& p) {
        return std::array{p.box.lo.x, p.box.lo.y, p.box.lo.z, p.box.hi.x, p.box.hi.y, p.box.hi.z};
    };
    std::stable_sort(pieces.begin() + first, pieces.end(),
                     [&](const Piece& a, const Piece& b) { return key(a) < key(b); });
}

double cap_area(Cut& cut)
{
    double area = 0.0;
    for (const Side side : {Side::positive, Side::negative})
        for (std::size_t i = 0; const Object* const piece = cut.piece(side, i); ++i) area += sim::cap_area(*piece);
    return area;
}

std::vector<Part> weigh(std::vector<Piece>& pieces, const MeshPose& pose)
{
    std::vector<Part> parts;
    parts.reserve(pieces.size());
    for (Piece& piece : pieces) {
        piece.solid = solid_of(piece.object.mass_properties(), piece.box, pose.scale);
        Part part;
        part.positive = piece.positive;
        part.mass = piece.solid.mass;
        part.centre = pose.to_world(piece.solid.centre);
        part.inertia = pose.rotation * piece.solid.inertia() * glm::transpose(pose.rotation);
        parts.push_back(part);
    }
    return parts;
}

Identity piece_of(const Identity& parent, const CutRecord& record, ObjectId id)
{
    Identity piece = heir_of(parent, id, record.tick, record.swipe, {record.number, record.tick + kSiblingTicks});
    piece.closed_rightly = record.origin_closed_rightly && record.closed_rightly;
    return piece;
}

void hash_surfaces(const World& world, CutRecord& record)
{
    std::array<std::uint64_t, 2> sides{};
    for (PieceRecord& piece : record.pieces) {
        piece.surface_hash = surface_hash(world.find(piece.id)->object());
        sides[piece.positive ? 1 : 0] += piece.surface_hash;
    }
    StateHash both;
    both.add(sides[1]);
    both.add(sides[0]);
    record.surface_hash = both.value();
}

}  // namespace

void cut_body(World& world, ObjectId id, const WorldPlane& plane, const CutBodyOptions& options, CutRecord& record)
{
    Body& body = *world.find(id);
    double caps_before = 0.0;
    if (options.hash_surfaces) {
        core::CpuStopwatch check;
        caps_before = sim::cap_area(body.object());
        record.check_cpu_ms = check.lap() * 1e3;
    }
    core::CpuStopwatch cpu;
    core::Stopwatch watch;
    const Origin& origin = body.identity().origin;
    record.object = id;
    record.model = origin.model;
    record.backend = origin.backend;
    record.centre = body.centre();
    record.normal = plane.normal;
    record.origin_closed_rightly = body.identity().closed_rightly;

    const MeshPose pose = body.pose();
    const std::optional<Plane> section = object_plane(plane, pose, origin);
    if (!section) {
        record.status = Status::invalid_argument;
        return body.mark_missed(record.swipe);
    }
    const WorldPlane placed = world_plane(*section, pose);
    record.normal = placed.normal;

    CutOptions how;
    how.components = true;
    watch.lap();
    Cut result = cut(body.take_object(), *section, how);
    record.cut_ms = watch.lap();
    record.status = result.status;
    record.statistics = result.statistics();
    record.section_area = result.section_area;
    if (result.object) {
        body.put_back(std::move(result.object));
        body.mark_missed(record.swipe);
        record.cpu_ms = cpu.lap() * 1e3;
        return;
    }
    if (options.hash_surfaces) {
        record.cpu_ms = cpu.lap() * 1e3;
        const double caps_after = cap_area(result);
        record.closed_rightly = is_closed_rightly(caps_before, caps_after, record.section_area);
        record.check_cpu_ms += cpu.lap() * 1e3;
        watch.lap();
    }

    std::vector<Piece> pieces;
    pieces.reserve(kUsualPieces);
    append(pieces, result, Side::positive);
    append(pieces, result, Side::negative);
    std::vector<Part> parts = weigh(pieces, pose);
    part_ways(body.centre(), body.motion(), placed.normal, placed.point, parts);

    const std::unique_ptr<Body> parent = world.remove(id);
    std::vector<Candidate> candidates;
    for (const Piece& piece : pieces) candidates.push_back({piece.solid.mass, world_box(piece.box, pose)});
    const PieceChoice choice = choose_heaviest(candidates, world);
    record.crowded = choice.crowded;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        Piece& piece = pieces[i];
        if (!choice.stays[i]) {
            ++record.dropped;
            continue;
        }
        const std::uint64_t triangles = piece.object.triangle_count();
        const Body& made = world.add(std::make_unique<Body>(piece_of(parent->identity(), record, ++*options.last_id),
                                                            std::move(piece.object), piece.solid, pose, parts[i].motion,
                                                            options.proxy));
        record.proxy_ms += made.proxy_ms();
        record.pieces.push_back({made.id(), piece.positive, made.mass(), triangles, 0});
    }
    record.bodies_ms = watch.lap() - record.proxy_ms;
    record.cpu_ms += cpu.lap() * 1e3;
    if (!options.hash_surfaces) return;
    hash_surfaces(world, record);
    record.check_cpu_ms += cpu.lap() * 1e3;
}

}  // namespace kerf::sim
