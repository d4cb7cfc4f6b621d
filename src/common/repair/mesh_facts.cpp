#include "common/repair/mesh_facts.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "common/geometry/disjoint_sets.h"
#include "common/mesh/mass_properties.h"
#include "common/repair/halfedges_by_edge.h"
#include "common/repair/linked_surface.h"
#include "common/repair/triangle_faults.h"
#include "common/repair/vertex_fans.h"
#include "common/repair/weld.h"

namespace kerf {

namespace {

std::uint64_t count_sets(DisjointSets& sets, std::uint32_t size)
{
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < size; ++i) count += sets.find(i) == i;
    return count;
}

/// Facts of connectivity; `all_corners` are point ids.
void measure_connectivity(MeshFacts& facts, std::uint32_t point_count, std::span<const Triangle> all_corners)
{
    Buffer<Triangle> corners;
    corners.reserve(all_corners.size());
    const Faults faults = find_faults(point_count, all_corners);
    for (std::size_t t = 0; t < all_corners.size(); ++t) {
        facts.degenerate_triangles += faults.of[t] == TriangleFault::degenerate;
        if (faults.of[t] == TriangleFault::degenerate) continue;
        corners.push_back(all_corners[t]);
    }

    facts.duplicate_triangles = faults.repeats;
    const auto triangle_count = static_cast<std::uint32_t>(corners.size());
    const auto start = [&](std::uint32_t h) { return corners[h / 3][h % 3]; };
    const HalfedgesByEdge edges(point_count, corners);
    DisjointSets shells(triangle_count), loops(point_count);
    Buffer<std::uint8_t> on_boundary(point_count, 0);
    edges.for_each([&](std::span<const HalfedgesByEdge::Side> edge) {
        const std::uint32_t h = edge[0].halfedge;
        for (const HalfedgesByEdge::Side& side : edge.subspan(1)) shells.unite(h / 3, side.halfedge / 3);
        if (edge.size() == 1) {
            ++facts.boundary_edges;
            on_boundary[start(h)] = on_boundary[start(next_halfedge(h))] = 1;
            loops.unite(start(h), start(next_halfedge(h)));
        } else if (edge.size() == 2) {
            facts.misoriented_edges += start(h) == start(edge[1].halfedge);
        } else {
            ++facts.nonmanifold_edges;
        }
        std::int64_t balance = 0;
        for (const HalfedgesByEdge::Side& side : edge) balance += start(side.halfedge) == start(h) ? 1 : -1;
        facts.unbalanced_edges += balance != 0;
    });
    facts.shells = count_sets(shells, triangle_count);
    for (std::uint32_t p = 0; p < point_count; ++p) facts.boundary_loops += on_boundary[p] && loops.find(p) == p;
    facts.nonmanifold_points = count_umbrella_points(point_count, corners, edges);
    facts.open_edges = facts.boundary_edges;
    if (facts.misoriented_edges + facts.nonmanifold_edges + facts.duplicate_triangles == 0) return;
    Buffer<Triangle> kept;
    for (std::size_t t = 0; t < all_corners.size(); ++t)
        if (is_kept(faults.of[t])) {
            kept.push_back(all_corners[t]);
            if (faults.is_turned_over(t)) std::swap(kept.back()[1], kept.back()[2]);
        }
    facts.open_edges = count_open_edges(std::move(kept), point_count);
}

void measure_geometry(MeshFacts& facts, std::span<const Vertex> vertices, std::span<const Triangle> triangles)
{
    for (const Vertex& v : vertices) facts.bounds.add(v.position);
    // An open mesh has no volume of its own; the origin is the reference point that other programs take.
    const glm::dvec3 reference = facts.closed() && !facts.bounds.empty() ? facts.bounds.centre() : glm::dvec3(0.0);
    MassMoments moments;
    for (const auto& [a, b, c] : triangles) {
        const glm::vec3 &p = vertices[a].position, &q = vertices[b].position, &r = vertices[c].position;
        moments.add(reference, p, q, r);
        facts.area += 0.5 * glm::length(glm::cross(glm::dvec3(q) - glm::dvec3(p), glm::dvec3(r) - glm::dvec3(p)));
    }
    facts.volume = moments.volume6 / 6.0;
    facts.shortest_edge = shortest_edge(vertices, triangles);
}

MeshFacts measure(std::span<const Vertex> vertices, std::span<const std::uint32_t> points, std::uint32_t point_count,
                  std::span<const Triangle> triangles)
{
    MeshFacts facts;
    facts.triangles = triangles.size();
    facts.vertices = vertices.size();
    facts.welded_vertices = point_count;
    Buffer<Triangle> corners(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) corners[t][i] = points[triangles[t][i]];
    measure_connectivity(facts, point_count, corners);
    measure_geometry(facts, vertices, triangles);
    return facts;
}

}  // namespace

MeshFacts measure(const TriangleSoup& soup)
{
    if (!are_in_range(soup.triangles, soup.vertices.size())) return {};
    const Weld weld = weld_positions(soup.vertices);
    return measure(soup.vertices, weld.points, weld.point_count, soup.triangles);
}

MeshFacts measure(const IndexedMesh& mesh)
{
    const bool has_points = mesh.points.size() == mesh.vertices.size() && mesh.point_count <= mesh.points.size() &&
                            std::all_of(mesh.points.begin(), mesh.points.end(),
                                        [&](std::uint32_t point) { return point < mesh.point_count; });
    if (!has_points || !are_in_range(mesh.triangles, mesh.vertices.size())) return {};
    return measure(mesh.vertices, mesh.points, mesh.point_count, mesh.triangles);
}

}  // namespace kerf
