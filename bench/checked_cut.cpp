#include "bench/checked_cut.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>

#include "common/mesh/plane_noise.h"
#include "common/mesh/support_points.h"
#include "common/proxy/convex_hull.h"
#include "common/repair/mesh_facts.h"
#include "common/support/random.h"

namespace kerf::bench {

namespace {

double surface_area(const IndexedMesh& mesh)
{
    double twice = 0.0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.kind != TriangleKind::surface) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            const glm::dvec3 p(mesh.vertices[a].position), q(mesh.vertices[b].position), r(mesh.vertices[c].position);
            twice += glm::length(glm::cross(q - p, r - p));
        }
    }
    return twice / 2;
}

}  // namespace

std::vector<Plane> planes_through_the_middle(const Box& bounds, std::uint32_t count, std::uint64_t seed)
{
    std::vector<Plane> planes;
    Random random(seed);
    while (planes.size() < count) {
        // Uniform on the sphere: height and longitude are independent (Archimedes).
        const double z = 2 * random.unit() - 1, angle = 6.283185307179586 * random.unit();
        const double r = std::sqrt(1 - z * z);
        if (const auto plane = Plane::through(bounds.centre(), {r * std::cos(angle), r * std::sin(angle), z}))
            planes.push_back(*plane);
    }
    return planes;
}

std::string check_cut(const Cuttable& object, const Plane& plane, CutCounts* counted)
{
    constexpr double kShare = 1e-6;  // of the whole: what rounding cut points to float may change
    const double volume = object.mass_properties().volume, area = surface_area(object.to_indexed_mesh());
    const double noise = plane_noise(object.bounds().largest_coordinate());
    const CutResult result = cut(object.clone(), plane);
    if (result.status != Status::done) return "status " + std::string(name_of(result.status));
    if (counted) {
        const CutStatistics& s = result.statistics;
        counted->all.crossing_triangles += s.crossing_triangles;
        counted->all.triangles_touched += s.triangles_touched;
        counted->all.nodes_visited += s.nodes_visited;
        counted->all.bytes_to_upload += s.bytes_to_upload;
        counted->report.vertex_comparisons += baseline::report_costs(result).vertex_comparisons;
    }
    double volume_sum = 0.0, area_sum = 0.0;
    for (const auto* side : {&result.positive, &result.negative})
        for (const auto& fragment : *side) {
            const IndexedMesh mesh = fragment->to_indexed_mesh();
            const MeshFacts facts = measure(mesh);
            if (!facts.closed()) return "a side is not closed";
            if (facts.degenerate_triangles > 0) return "a triangle has two corners in one place";
            for (const Vertex& v : mesh.vertices) {
                const double d = plane.signed_distance(v.position);
                if ((side == &result.positive ? -d : d) > noise) return "a vertex is on the wrong side";
            }
            volume_sum += fragment->mass_properties().volume;
            area_sum += surface_area(mesh);
        }
    if (!(std::abs(volume_sum - volume) <= kShare * std::abs(volume))) return "volumes do not add up";
    if (!(std::abs(area_sum - area) <= kShare * area)) return "surface areas do not add up";
    return {};
}

double proxy_volume(const CollisionProxy& proxy)
{
    constexpr double kPi = 3.14159265358979323846;
    if (proxy.kind == ProxyKind::box) {
        const glm::dvec3 size = glm::dvec3(proxy.box.hi) - glm::dvec3(proxy.box.lo);
        return size.x * size.y * size.z;
    }
    if (proxy.kind == ProxyKind::sphere) return 4.0 / 3.0 * kPi * std::pow(double(proxy.radius), 3);
    const ConvexHull hull = convex_hull(proxy.points);
    double six = 0.0;
    for (const Triangle& face : hull.faces) {
        // About the first corner, so that coordinates far from the origin cost nothing.
        const auto corner = [&](std::size_t i) {
            return glm::dvec3(proxy.points[hull.corners[face[i]]]) - glm::dvec3(proxy.points[hull.corners[0]]);
        };
        six += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    return six / 6.0;
}

std::string check_proxy(const CollisionProxy& proxy, std::span<const Vertex> vertices)
{
    if (proxy.kind == ProxyKind::box || proxy.kind == ProxyKind::sphere) {
        for (const Vertex& v : vertices) {
            const glm::vec3& p = v.position;
            const bool in_box =
                glm::all(glm::lessThanEqual(proxy.box.lo, p)) && glm::all(glm::lessThanEqual(p, proxy.box.hi));
            const bool in_sphere = proxy.kind == ProxyKind::box ||
                                   glm::distance(glm::dvec3(p), glm::dvec3(proxy.centre)) <= double(proxy.radius);
            if (!in_box || !in_sphere) return "a vertex is outside its proxy";
        }
        return {};
    }
    const auto farthest = [](const glm::vec3& direction, auto&& points, auto&& position) {
        float most = -std::numeric_limits<float>::infinity();
        for (const auto& p : points) most = std::max(most, support_value(direction, position(p)));
        return most;
    };
    for (const glm::vec3& direction : support_directions()) {
        const float of_mesh = farthest(direction, vertices, [](const Vertex& v) { return v.position; });
        const float of_hull = farthest(direction, proxy.points, [](const glm::vec3& p) { return p; });
        // A full hull is computed on a lattice: convex_hull.h says how far a vertex may stick out.
        const float slack = proxy.kind == ProxyKind::full_hull ? 2e-4f * proxy.box.largest_coordinate() : 0.0f;
        if (of_hull > of_mesh || of_hull < of_mesh - slack) return "a hull does not reach as far as its vertices";
    }
    return {};
}

}  // namespace kerf::bench
