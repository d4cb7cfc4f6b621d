#include "common/repair/mesh_facts.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "common/geometry/disjoint_sets.h"
#include "common/mesh/mass_moments.h"
#include "common/mesh/mass_properties.h"
#include "common/repair/halfedges_by_edge.h"
#include "common/repair/linked_surface.h"
#include "common/repair/measuring_steps.h"
#include "common/repair/triangle_faults.h"
#include "common/repair/vertex_fans.h"
#include "common/repair/weld.h"

namespace kerf::core {

namespace {

std::uint64_t count_sets(DisjointSets& sets, std::uint32_t size)
{
    std::uint64_t count = 0;
    for (std::uint32_t i = 0; i < size; ++i) count += sets.find(i) == i;
    return count;
}

/// The loops of edges with one triangle: connected parts of the boundary.
class BoundaryLoops
{
public:
    explicit BoundaryLoops(std::uint32_t point_count) : point_count_(point_count), points_(0) {}

    void add(std::uint32_t from, std::uint32_t to)
    {
        if (on_boundary_.empty()) {
            on_boundary_.assign(point_count_, 0);
            points_ = DisjointSets(point_count_);
        }
        on_boundary_[from] = on_boundary_[to] = 1;
        points_.unite(from, to);
    }

    std::uint64_t count()
    {
        std::uint64_t loops = 0;
        for (std::uint32_t p = 0; p < on_boundary_.size(); ++p) loops += on_boundary_[p] && points_.find(p) == p;
        return loops;
    }

private:
    std::uint32_t point_count_;
    DisjointSets points_;
    Buffer<std::uint8_t> on_boundary_;  ///< empty without a boundary
};

MeshFacts measure(std::span<const Vertex> vertices, std::span<const std::uint32_t> points, std::uint32_t point_count,
                  std::span<const Triangle> triangles)
{
    Buffer<Triangle> corners(triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) corners[t][i] = points[triangles[t][i]];
    const Faults faults = find_faults(point_count, corners);
    MeshFacts facts = count_triangles(vertices.size(), point_count, faults);
    count_connectivity(facts, point_count, corners, faults);
    facts.open_edges = facts.boundary_edges;
    if (!is_linked_plainly(facts))
        facts.open_edges = count_open_edges(keep(std::move(corners), faults).corners, point_count);
    measure_geometry(facts, vertices, triangles);
    return facts;
}

}  // namespace

MeshFacts count_triangles(std::size_t vertex_count, std::uint32_t point_count, const Faults& faults)
{
    MeshFacts facts;
    facts.triangles = faults.of.size();
    facts.vertices = vertex_count;
    facts.welded_vertices = point_count;
    facts.degenerate_triangles =
        static_cast<std::uint64_t>(std::count(faults.of.begin(), faults.of.end(), TriangleFault::degenerate));
    facts.duplicate_triangles = faults.repeats;
    return facts;
}

void count_edges(MeshFacts& facts, std::uint32_t point_count, std::span<const Triangle> corners, HalfedgesByEdge& edges)
{
    const auto start = [&](std::uint32_t h) { return start_of(corners, h); };
    BoundaryLoops loops(point_count);
    edges.for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
        const std::uint32_t h = edge[0].halfedge;
        if (edge.size() == 2) {
            const bool agree = start(h) != start(edge[1].halfedge);
            facts.misoriented_edges += !agree;
            facts.unbalanced_edges += !agree;
            return;
        }
        if (edge.size() == 1) {
            ++facts.boundary_edges;
            loops.add(start(h), start(next_halfedge(h)));
        } else {
            ++facts.nonmanifold_edges;
        }
        std::int64_t balance = 0;
        for (const HalfedgesByEdge::Entry& entry : edge) balance += start(entry.halfedge) == start(h) ? 1 : -1;
        facts.unbalanced_edges += balance != 0;
    });
    facts.boundary_loops = loops.count();
}

void count_components(MeshFacts& facts, std::uint32_t point_count, std::span<const Triangle> corners,
                      HalfedgesByEdge& edges)
{
    const auto triangle_count = static_cast<std::uint32_t>(corners.size());
    DisjointSets shells(triangle_count);
    edges.for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
        for (const HalfedgesByEdge::Entry& entry : edge.subspan(1))
            shells.unite(edge[0].halfedge / 3, entry.halfedge / 3);
    });
    facts.shells = count_sets(shells, triangle_count);
    facts.nonmanifold_points = count_nonmanifold_points(point_count, corners, edges);
}

void count_connectivity(MeshFacts& facts, std::uint32_t point_count, std::span<const Triangle> corners,
                        const Faults& faults)
{
    Buffer<Triangle> others;
    others.reserve(corners.size());
    for (std::size_t t = 0; t < corners.size(); ++t)
        if (faults.of[t] != TriangleFault::degenerate) others.push_back(corners[t]);
    HalfedgesByEdge edges(point_count, others);
    count_edges(facts, point_count, others, edges);
    count_components(facts, point_count, others, edges);
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

}  // namespace kerf::core
