// Any mesh, any planes, both back ends: what docs/cutting-rules.md promises.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "baseline/baseline.h"
#include "common/cutting/cut.h"
#include "common/mesh/plane_noise.h"
#include "common/repair/repair.h"
#include "fuzz/byte_reader.h"
#include "fuzz/fuzzers.h"
#include "fuzz/mesh_from_bytes.h"
#include "fuzz/require.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/check_universe.h"
#include "support/referee.h"

namespace kerf::core::fuzz {

namespace {

using Fragments = std::vector<std::unique_ptr<Cuttable>>;

/// A third cut finds nothing that two don't, and takes its time.
constexpr int kMostCuts = 2;

/// What sums of products of three coordinates may lose for each triangle, as a share of the extent's cube: some units
/// in the last place of a double. It matters where a fragment has next to no area.
constexpr double kSumRounding = 1e-15;

/// What a mesh is measured against.
struct Scale
{
    explicit Scale(const IndexedMesh& mesh)
        : noise(plane_noise(mesh.bounds().largest_coordinate())), area(referee::area(mesh))
    {
    }
    double noise;  ///< rounding of a cut point, mesh units
    double area;
};

std::unique_ptr<Cuttable> prepared(const Backend& backend, const IndexedMesh& mesh)
{
    PrepareResult result = backend.prepare(mesh);
    require(result.status == Status::done, backend.name() + ": a repaired mesh can be prepared");
    return std::move(result.object);
}

/// Buffers, ranges and counters of an object agree with its compact copy.
void require_consistent(const Cuttable& object, const IndexedMesh& mesh, const std::string& who)
{
    require(check(mesh).empty(), who + ": a fragment is a mesh (" + check(mesh) + ")");
    require(object.triangle_count() == mesh.triangles.size(), who + ": triangles are counted");
    require(object.bounds().lo == mesh.bounds().lo && object.bounds().hi == mesh.bounds().hi,
            who + ": bounds are those of the vertices");
    const DrawView view = object.draw_view();
    std::uint64_t drawn = 0;
    for (const DrawRange& range : view.ranges) {
        require(std::uint64_t{range.first_index} + range.index_count <= view.indices.size(),
                who + ": ranges lie in the index buffer");
        require(range.material < view.materials.size(), who + ": ranges have a material");
        for (std::uint32_t i = 0; i < range.index_count; ++i)
            require(view.indices[range.first_index + i] < view.vertices.size(), who + ": indices are of vertices");
        drawn += range.index_count;
    }
    require(drawn == 3 * object.triangle_count(), who + ": what is drawn is what there is");
    if (const auto* fragment = dynamic_cast<const halfedge::Fragment*>(&object)) {
        const std::string fault = halfedge::check_universe(fragment->universe(), fragment->shells());
        require(fault.empty(), who + ": the half-edge mesh is consistent (" + fault + ")");
    }
}

/// What every fragment keeps. `closed`: the object was, and caps were asked for.
void require_sound(const Fragments& side, const Plane& plane, bool is_positive, bool closed, const Scale& scale,
                   const std::string& who)
{
    require(!side.empty(), who + ": a cut has both sides");
    for (const auto& fragment : side) {
        const IndexedMesh mesh = fragment->to_indexed_mesh();
        require_consistent(*fragment, mesh, who);
        require(!mesh.triangles.empty(), who + ": no fragment is empty");
        require(referee::triangles_with_equal_corners(mesh) == 0, who + ": no triangle has two equal corners");
        require(referee::overhang(mesh, plane, is_positive) <= scale.noise, who + ": fragments keep to their side");
        if (!closed) continue;
        require(referee::open_edges(mesh) == 0, who + ": a closed mesh has closed fragments");
        require(referee::open_edges_by_position(mesh) == 0, who + ": ... by position as well");
        const double volume = referee::volume(mesh), area = referee::area(mesh);
        const double extent = glm::length(glm::dvec3(mesh.bounds().hi) - glm::dvec3(mesh.bounds().lo));
        const MassProperties mass = fragment->mass_properties();
        const double rounding = kSumRounding * double(mesh.triangles.size()) * extent * extent * extent;
        require(std::abs(mass.volume - volume) <= 1e-9 * area * extent + scale.noise * area + rounding,
                who + ": the volume is that of the mesh");
        require(std::isfinite(mass.centre.x + mass.centre.y + mass.centre.z), who + ": the centre of mass is a place");
    }
}

double volume_of(const Fragments& side)
{
    double sum = 0;
    for (const auto& fragment : side) sum += referee::volume(fragment->to_indexed_mesh());
    return sum;
}

double area_of(const Fragments& side)
{
    double sum = 0;
    for (const auto& fragment : side) sum += referee::area(fragment->to_indexed_mesh());
    return sum;
}

/// Signed area of the caps about the plane's normal.
double cap_area(const Fragments& side, const Plane& plane)
{
    double twice = 0;
    for (const auto& fragment : side) {
        const IndexedMesh mesh = fragment->to_indexed_mesh();
        for (const TriangleGroup& group : mesh.groups) {
            if (group.kind != TriangleKind::cap) continue;
            for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
                const auto at = [&](std::size_t k) { return glm::dvec3(mesh.vertices[mesh.triangles[t][k]].position); };
                twice += glm::dot(glm::cross(at(1) - at(0), at(2) - at(0)), plane.normal);
            }
        }
    }
    return twice / 2;
}

std::vector<std::vector<std::uint32_t>> bytes_of(const Fragments& side)
{
    std::vector<std::vector<std::uint32_t>> all;
    for (const auto& fragment : side) all.push_back(referee::bytes_of(fragment->to_indexed_mesh()));
    return all;
}

std::vector<std::vector<referee::SurfaceTriangle>> surfaces_of(const Fragments& side)
{
    std::vector<std::vector<referee::SurfaceTriangle>> all;
    for (const auto& fragment : side) all.push_back(referee::canonical_surface(fragment->to_indexed_mesh()));
    std::sort(all.begin(), all.end());
    return all;
}

/// A mesh that has just been prepared, cut once by a back end. Bits of `more` choose what else is looked at.
CutResult cut_fresh(const Backend& backend, const IndexedMesh& mesh, const Plane& plane, const CutOptions& options,
                    std::uint8_t more)
{
    const std::string who = backend.name();
    const bool closed = referee::open_edges(mesh) == 0;
    const bool has_caps = std::any_of(mesh.groups.begin(), mesh.groups.end(),
                                      [](const TriangleGroup& g) { return g.kind == TriangleKind::cap; });
    const Scale scale(mesh);

    const auto object = prepared(backend, mesh);
    require_consistent(*object, object->to_indexed_mesh(), who);
    CutResult result = cut(object->clone(), plane, options);
    // Each of these costs another cut: not all of them for every input.
    if ((more & 1) != 0) {
        const CutResult again = cut(prepared(backend, mesh), plane, options);
        require(result.status == again.status && bytes_of(result.positive) == bytes_of(again.positive) &&
                    bytes_of(result.negative) == bytes_of(again.negative),
                who + ": the same cut gives the same bytes");
    }
    if ((more & 2) != 0) {
        const CutResult flipped = cut(object->clone(), plane.flipped(), options);
        require(result.status == flipped.status, who + ": a plane has the same status from behind");
        require(referee::canonical_surface(result.positive) == referee::canonical_surface(flipped.negative) &&
                    referee::canonical_surface(result.negative) == referee::canonical_surface(flipped.positive),
                who + ": a flipped plane swaps the sides");
    }
    if (result.status == Status::missed) {
        require(result.object != nullptr, who + ": what is missed comes back");
        require(referee::bytes_of(result.object->to_indexed_mesh()) == referee::bytes_of(object->to_indexed_mesh()),
                who + ": what is missed comes back unharmed");
        return result;
    }
    require(result.status == Status::done || (result.status == Status::open_section && !closed),
            who + ": a closed mesh has a closed section, not " + std::string(name_of(result.status)));
    require_sound(result.positive, plane, true, closed && options.build_caps, scale, who);
    require_sound(result.negative, plane, false, closed && options.build_caps, scale, who);
    if (closed && options.build_caps) {
        const double extent = glm::length(glm::dvec3(mesh.bounds().hi) - glm::dvec3(mesh.bounds().lo));
        const double area = scale.area + area_of(result.positive) + area_of(result.negative);
        require(std::abs(volume_of(result.positive) + volume_of(result.negative) - referee::volume(mesh)) <=
                    1e-9 * area * extent + scale.noise * area,
                who + ": the volumes add up");
        if (!has_caps) {
            const double rounding = 1e-9 * area + scale.noise * extent;
            require(std::abs(cap_area(result.negative, plane) - result.section_area) <= rounding &&
                        std::abs(cap_area(result.positive, plane) + result.section_area) <= rounding,
                    who + ": caps cover the section");
        }
    }
    if ((more & 4) == 0) return result;
    for (const Fragments* side : {&result.positive, &result.negative})
        for (const auto& fragment : *side)
            require(cut(fragment->clone(), plane, options).status == Status::missed,
                    who + ": a fragment misses the plane that made it");
    return result;
}

/// The fragments' own lives go on: cut by plane after plane, with all that earlier cuts have left behind.
void cut_on(Fragments objects, ByteReader& bytes, const CutOptions& options, bool closed, const std::string& who)
{
    for (int i = 0; i < kMostCuts && !objects.empty(); ++i) {
        const std::size_t chosen = bytes.below(static_cast<std::uint32_t>(objects.size()));
        std::unique_ptr<Cuttable> object = std::move(objects[chosen]);
        if (object == nullptr) return;
        if (bytes.byte() % 8 == 0) {
            const auto before = referee::bytes_of(object->to_indexed_mesh());
            object->compact();
            require(before == referee::bytes_of(object->to_indexed_mesh()), who + ": compaction keeps the bytes");
        }
        const IndexedMesh mesh = object->to_indexed_mesh();
        const Plane plane = plane_from(bytes, mesh);
        CutResult result = cut(std::move(object), plane, options);
        if (result.status == Status::missed) {
            objects[chosen] = std::move(result.object);
            continue;
        }
        require(result.status == Status::done || (result.status == Status::open_section && !closed),
                who + ": a closed fragment has a closed section");
        require_sound(result.positive, plane, true, closed && options.build_caps, Scale(mesh), who);
        require_sound(result.negative, plane, false, closed && options.build_caps, Scale(mesh), who);
        objects = std::move(bytes.byte() % 2 == 0 ? result.positive : result.negative);
    }
}

}  // namespace

void fuzz_cut(Bytes input)
{
    ByteReader bytes(input);
    const std::uint8_t setting = bytes.byte();
    CutOptions options;
    options.split_components = (setting & 1) != 0;
    options.build_caps = setting % 16 != 0;
    const auto lookup = static_cast<baseline::VertexLookup>((setting >> 4) % 4);

    Repaired repaired = repair(soup_from(bytes));
    if (!repaired.error.empty()) return;
    require(is_manifold(repaired.mesh), "a repaired mesh is manifold");
    const std::array<std::unique_ptr<Backend>, 2> backends{baseline::make_back_end(lookup), halfedge::make_back_end()};
    IndexedMesh mesh = *std::move(repaired.mesh);
    for (int i = 0; i < kMostCuts; ++i) {
        const Plane plane = plane_from(bytes, mesh);
        const std::uint8_t more = bytes.byte();
        std::array<CutResult, 2> results;
        for (std::size_t b = 0; b < 2; ++b) results[b] = cut_fresh(*backends[b], mesh, plane, options, more);
        require(results[0].status == results[1].status,
                "both back ends say the same: " + std::string(name_of(results[0].status)) + ", " +
                    std::string(name_of(results[1].status)));
        require(referee::canonical_surface(results[0].positive) == referee::canonical_surface(results[1].positive) &&
                    referee::canonical_surface(results[0].negative) == referee::canonical_surface(results[1].negative),
                "both back ends make the same sides of the surface");
        require(surfaces_of(results[0].positive) == surfaces_of(results[1].positive) &&
                    surfaces_of(results[0].negative) == surfaces_of(results[1].negative),
                "both back ends make the same pieces of the surface");
        require(results[0].section_area == results[1].section_area,
                "both back ends find one section area: " + std::to_string(results[0].section_area) + ", " +
                    std::to_string(results[1].section_area));
        require(results[0].statistics.section_loops == results[1].statistics.section_loops &&
                    results[0].statistics.open_chains == results[1].statistics.open_chains,
                "both back ends divide a section into the same loops and chains");
        if (results[0].status == Status::missed) continue;

        // The next mesh is a piece, with the caps of either back end.
        const std::uint8_t next = bytes.byte();
        CutResult& chosen = results[next % 2];
        Fragments& side = (next & 2) != 0 ? chosen.positive : chosen.negative;
        IndexedMesh piece = side[(next >> 2) % side.size()]->to_indexed_mesh();
        const bool closed = referee::open_edges(mesh) == 0;
        for (std::size_t b = 0; b < 2; ++b)
            cut_on(std::move((next & 64) != 0 ? results[b].positive : results[b].negative), bytes, options,
                   closed && options.build_caps, backends[b]->name() + ", cut on");
        // A cap may run along an edge of the surface, or join fans in a point where the section touches itself: only
        // the back end that made it goes on with such a piece.
        if (!is_manifold(piece)) return;
        mesh = std::move(piece);
    }
}

}  // namespace kerf::core::fuzz
