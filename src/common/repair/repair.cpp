#include "common/repair/repair.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "common/mesh/is_finite.h"
#include "common/repair/clean_soup.h"
#include "common/repair/linked_surface.h"
#include "common/repair/measuring_steps.h"
#include "common/repair/shells.h"
#include "common/repair/solids.h"
#include "common/repair/triangle_faults.h"
#include "common/repair/vertex_builder.h"
#include "common/repair/vertex_fans.h"
#include "common/repair/weld.h"
#include "common/support/reason.h"

// Triangles that face the wrong way are turned over in three steps: sheets of triangles over the same points
// (orient_sheets.h, if triangle_faults.h finds edges that need it), patches that are connected by edges of two
// triangles (orient_patches.h), and whole shells (solids.h).

namespace kerf::core {

namespace {

constexpr std::size_t kLargestIndex = std::numeric_limits<std::uint32_t>::max();

std::string fault_of_sizes(const TriangleSoup& soup)
{
    if (soup.triangles.empty()) return "the mesh has no triangles; give it one at least";
    if (soup.triangles.size() > kLargestIndex / 3 || soup.vertices.size() >= kLargestIndex)
        return "the mesh has more than 2^32 corners; divide it into several";
    return {};
}

std::string fault_of_positions(const TriangleSoup& soup)
{
    for (std::size_t v = 0; v < soup.vertices.size(); ++v)
        if (!is_finite(soup.vertices[v].position))
            return "vertex " + std::to_string(v) +
                   " has a coordinate that is not finite; give it a number, or take it and its triangles out";
    return {};
}

std::string fault_of_indices(const TriangleSoup& soup)
{
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        for (const std::uint32_t v : soup.triangles[t])
            if (v >= soup.vertices.size())
                return "triangle " + std::to_string(t) + " refers to vertex " + std::to_string(v) +
                       but_there_are_only(soup.vertices.size());
    return {};
}

std::string fault_of_attributes(const TriangleSoup& soup)
{
    if (!soup.triangle_materials.empty() && soup.triangle_materials.size() != soup.triangles.size())
        return "there is not one material for each triangle; name one for each, or none at all";
    const std::size_t material_count = std::max<std::size_t>(1, soup.materials.size());
    for (std::size_t t = 0; t < soup.triangle_materials.size(); ++t)
        if (soup.triangle_materials[t] >= material_count)
            return "triangle " + std::to_string(t) + " refers to material " +
                   std::to_string(soup.triangle_materials[t]) + but_there_are_only(material_count);
    for (const VertexStream& stream : soup.streams)
        if (stream.width == 0 || stream.values.size() != soup.vertices.size() * stream.width)
            return "stream " + in_quotes(stream.name) + " does not have " + std::to_string(stream.width) +
                   " values per vertex; complete it or leave it out";
    return {};
}

/// The points at the corners of a soup's triangles.
struct Corners
{
    Buffer<Triangle> points;  ///< for each triangle; empty if one refers to a vertex that is not there
    bool has_degenerate = false;
};

/// One pass, because reading triangles costs more than all that is asked of them.
Corners corners_by_point(const TriangleSoup& soup, const Weld& weld)
{
    Corners corners;
    corners.points.resize(soup.triangles.size());
    for (std::size_t t = 0; t < corners.points.size(); ++t) {
        const auto& [i, j, k] = soup.triangles[t];
        if (std::max({i, j, k}) >= weld.points.size()) return {};
        const std::uint32_t a = weld.points[i], b = weld.points[j], c = weld.points[k];
        corners.points[t] = {a, b, c};
        corners.has_degenerate |= (a == b) | (b == c) | (c == a);
    }
    return corners;
}

void count_faults(Repairs& repairs, const Faults& faults)
{
    for (const TriangleFault fault : faults.of) {
        repairs.degenerate_triangles += fault == TriangleFault::degenerate;
        repairs.duplicate_triangles += fault == TriangleFault::duplicate;
        repairs.coinciding_triangles += fault == TriangleFault::coinciding;
    }
}

/// The edges of triangles and, if nothing about them is to be decided, the neighbours.
struct Links
{
    std::optional<HalfedgesByEdge> edges;  ///< none if triangles are degenerate
    Buffer<std::uint32_t> opposite;        ///< empty: link_surface() decides
};

/// Most meshes have no fault: linking them shows that, and costs less than to look for faults first.
Links try_to_link(std::uint32_t point_count, const Corners& corners)
{
    Links links;
    if (corners.has_degenerate) return links;
    links.edges.emplace(point_count, corners.points);
    if (!link_plainly(corners.points, *links.edges, links.opposite)) links.opposite.clear();
    return links;
}

/// Links triangles, as far as `links` has not done so. Counts the edges of the soup on the way, if they are wanted and
/// its duplicate triangles have not been looked at already.
LinkedSurface link_and_count(Buffer<Triangle> corners, Links links, std::span<const glm::vec3> positions,
                             FactsWanted facts_wanted, std::vector<NonmanifoldEdge>& resolved, MeshFacts& facts)
{
    const auto point_count = static_cast<std::uint32_t>(positions.size());
    const bool counts = facts_wanted != FactsWanted::none;
    if (counts && facts.duplicate_triangles == 0) {
        count_edges(facts, point_count, corners, *links.edges);
        if (!is_linked_plainly(facts)) count_components(facts, point_count, corners, *links.edges);
    }
    LinkedSurface surface = links.opposite.empty() ? link_surface(std::move(corners), *links.edges, positions, resolved)
                                                   : plain_surface(std::move(corners), std::move(links.opposite));
    if (counts)
        facts.open_edges =
            static_cast<std::uint64_t>(std::count(surface.opposite.begin(), surface.opposite.end(), kNone));
    return surface;
}

/// Turns over the shells that are inside out.
void turn_over_shells(LinkedSurface& surface, VertexFans& fans, const Shells& shells, const Solids& solids)
{
    if (std::find(solids.flip.begin(), solids.flip.end(), 1) == solids.flip.end()) return;
    Buffer<std::uint8_t> flip(surface.corners.size());
    for (std::size_t t = 0; t < flip.size(); ++t) {
        flip[t] = solids.flip[shells.shell[t]];
        if (flip[t]) std::swap(fans.fan[3 * t + 1], fans.fan[3 * t + 2]);
    }
    surface.turn_over(flip);
}

/// Sorts `order` by key, stably, by counting.
template <class KeyOf>
void counting_sort(Buffer<std::uint32_t>& order, std::size_t key_count, KeyOf&& key_of)
{
    if (key_count < 2) return;
    std::vector<std::uint32_t> next(key_count, 0);
    for (const std::uint32_t t : order) ++next[key_of(t)];
    std::uint32_t sum = 0;
    for (std::uint32_t& slot : next) sum += std::exchange(slot, sum);
    Buffer<std::uint32_t> sorted(order.size());
    for (const std::uint32_t t : order) sorted[next[key_of(t)]++] = t;
    order = std::move(sorted);
}

/// Puts triangles into groups by material, then solid, in otherwise unchanged order, and returns that order.
template <class MaterialOf, class SolidOf>
Buffer<std::uint32_t> make_groups(IndexedMesh& mesh, std::size_t triangle_count, std::size_t solid_count,
                                  MaterialOf&& material_of, SolidOf&& solid_of)
{
    Buffer<std::uint32_t> order(triangle_count);
    std::iota(order.begin(), order.end(), 0u);
    counting_sort(order, solid_count, solid_of);
    counting_sort(order, mesh.materials.size(), material_of);
    if (solid_count == 1 && mesh.materials.size() == 1) {
        mesh.groups.push_back({0, static_cast<std::uint32_t>(triangle_count), 0, 0, TriangleKind::surface});
        return order;
    }
    for (std::uint32_t i = 0; i < triangle_count; ++i) {
        const std::uint32_t material = material_of(order[i]), solid = solid_of(order[i]);
        if (mesh.groups.empty() || mesh.groups.back().material != material || mesh.groups.back().solid != solid)
            mesh.groups.push_back({i, 0, material, solid, TriangleKind::surface});
        ++mesh.groups.back().count;
    }
    return order;
}

/// The soup's materials, at least one, each with a name.
std::vector<Material> named_materials(std::vector<Material> materials)
{
    if (materials.empty()) materials.emplace_back().name = "surface";
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (materials[i].name.empty()) materials[i].name = "material " + std::to_string(i);
    return materials;
}

}  // namespace

std::string Repairs::describe() const
{
    std::string text;
    const auto clause = [&](std::uint64_t count, const char* one, const char* many, const char* what) {
        if (count == 0) return;
        if (!text.empty()) text += ", ";
        text += std::to_string(count) + " " + (count == 1 ? one : many) + " " + what;
    };
    clause(degenerate_triangles, "degenerate triangle", "degenerate triangles", "dropped");
    clause(duplicate_triangles, "duplicate triangle", "duplicate triangles", "dropped");
    clause(coinciding_triangles, "triangle that lies on another", "triangles that lie on others", "kept");
    clause(nonmanifold_edges, "edge", "edges", "with more than two triangles divided");
    clause(nonmanifold_points, "point", "points", "split");
    clause(flipped_triangles, "triangle", "triangles", "turned over");
    clause(unorientable_edges, "edge", "edges", "cut open where no orientation fits");
    clause(replaced_attributes, "vertex", "vertices", "with a normal or uv that is not finite given another");
    return text;
}

Repaired repair(TriangleSoup soup, FactsWanted facts_wanted)
{
    Repaired result;
    const auto refused = [&](std::string fault) {
        result.error = std::move(fault);
        return !result.error.empty();
    };
    if (refused(fault_of_sizes(soup))) return result;
    const Weld weld = weld_positions(soup.vertices);
    if (!weld.is_finite && refused(fault_of_positions(soup))) return result;
    Corners found = corners_by_point(soup, weld);
    if (found.points.empty() && refused(fault_of_indices(soup))) return result;
    if (refused(fault_of_attributes(soup))) return result;
    Repairs& repairs = result.repairs;

    repairs.replaced_attributes = clean(soup).vertices;
    Links links = try_to_link(weld.point_count, found);
    Buffer<Triangle>& corners = found.points;
    const Faults faults = links.opposite.empty() ? find_faults(weld.point_count, corners) : no_faults(corners.size());
    count_faults(repairs, faults);
    MeshFacts facts = count_triangles(soup.vertices.size(), weld.point_count, faults);
    const bool has_facts = facts_wanted == FactsWanted::all;
    if (has_facts && faults.repeats > 0) count_connectivity(facts, weld.point_count, corners, faults);
    KeptTriangles kept = keep(std::move(corners), faults);
    if (kept.corners.empty()) {
        result.error =
            "every triangle of the mesh is degenerate: two corners of each are at one position; export it again with "
            "positions that differ: with a scale that is not 0, with more digits, or nearer to the origin";
        return result;
    }
    if (kept.corners.size() < soup.triangles.size() || !kept.turned_over.empty())
        links.edges.emplace(weld.point_count, kept.corners);
    Buffer<glm::vec3> positions(weld.point_count);
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) positions[weld.points[v]] = soup.vertices[v].position;

    std::vector<NonmanifoldEdge> resolved;
    LinkedSurface surface =
        link_and_count(std::move(kept.corners), std::move(links), positions, facts_wanted, resolved, facts);
    repairs.nonmanifold_edges = surface.nonmanifold_edges;
    repairs.unorientable_edges = surface.unorientable_edges;
    for (std::size_t t = 0; !kept.turned_over.empty() && t < surface.flipped.size(); ++t)
        surface.flipped[t] ^= kept.turned_over[t];
    Buffer<std::uint8_t> is_used(weld.point_count, 0);
    VertexFans fans = find_vertex_fans(surface, resolved, is_used);
    fans.is_one_at_each_point = fans.count == std::accumulate(is_used.begin(), is_used.end(), std::uint32_t{0});
    if (!fans.is_one_at_each_point) {
        HalfedgesByEdge edges(weld.point_count, surface.corners);
        repairs.nonmanifold_points = count_nonmanifold_points(weld.point_count, surface.corners, edges);
    }

    Shells shells = find_shells(surface, fans, positions);
    if (has_facts) {
        if (is_linked_plainly(facts)) {
            facts.shells = shells.shells.size();
            facts.nonmanifold_points = repairs.nonmanifold_points;
        }
        measure_geometry(facts, soup.vertices, soup.triangles);
        result.facts = facts;
    }

    const Solids solids = find_solids(surface, shells, positions);
    turn_over_shells(surface, fans, shells, solids);
    repairs.flipped_triangles =
        static_cast<std::uint64_t>(std::count(surface.flipped.begin(), surface.flipped.end(), std::uint8_t{1}));

    IndexedMesh mesh;
    mesh.materials = named_materials(std::move(soup.materials));
    const auto material_of = [&](std::uint32_t t) {
        return soup.triangle_materials.empty() ? 0 : soup.triangle_materials[kept.from[t]];
    };
    const auto solid_of = [&](std::uint32_t t) { return solids.solid[shells.shell[t]]; };
    const std::size_t solid_count = std::size_t{*std::max_element(solids.solid.begin(), solids.solid.end())} + 1;
    const Buffer<std::uint32_t> order = make_groups(mesh, surface.corners.size(), solid_count, material_of, solid_of);
    mesh.sources.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) mesh.sources[i] = kept.from[order[i]];

    const Buffer<std::uint32_t> first_equal =
        first_equal_vertices(weld, soup.vertices, soup.streams, !soup.has_normals);
    build_vertices({soup, first_equal, kept.from, surface, fans, positions}, order, mesh);
    const Box bounds = shells.box();
    result.mesh =
        ProvenMesh(std::move(mesh), adjacency_in_order(std::move(surface.opposite), std::move(shells.shell), order),
                   bounds, shells.shortest_edge, shells.closed());
    return result;
}

}  // namespace kerf::core
