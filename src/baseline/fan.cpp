#include "baseline/fan.h"

#include <algorithm>
#include <cstdlib>

#include "common/cutting/back_end_helpers.h"
#include "common/geometry/dominant_axis.h"
#include "common/mesh/float_range.h"
#include "common/mesh/plane_frame.h"
#include "common/support/order_by.h"

namespace kerf::core::baseline {

using linear::SectionEdge;
using linear::SectionPoint;

glm::vec3 section_centre(const Section& section)
{
    glm::dvec3 sum{0.0};
    for (const SectionEdge& edge : section.edges) sum += glm::dvec3(section.points[edge.from].position);
    const glm::vec3 centre(sum / std::max<double>(1.0, double(section.edges.size())));
    return centre + 0.0f;  // -0 does not occur in a mesh
}

FanFacts measure_fan(const Section& section, std::span<const SectionPath> paths, const glm::vec3& centre,
                     const Plane& plane)
{
    FanFacts facts;
    const glm::dvec3 apex(centre);
    for (const SectionPath& path : paths) {
        if (!path.closed) continue;
        for (const std::uint32_t e : path.edges) {
            const glm::dvec3 a(section.points[section.edges[e].from].position),
                b(section.points[section.edges[e].to].position);
            facts.excess -= std::min(0.0, glm::dot(plane.normal, glm::cross(a - apex, b - apex)));
            facts.rim += glm::distance(a, b);
        }
    }
    return facts;
}

namespace {

bool has_point_at(const Section& section, const SectionPath& path, const glm::vec3& position)
{
    return std::any_of(path.edges.begin(), path.edges.end(), [&](std::uint32_t e) {
        return same_position(section.points[section.edges[e].from].position, position);
    });
}

/// A place near `centre` where no point of the path lies: within the plane, as far as `step`, the unit in the last
/// place of the mesh's largest coordinate, allows.
glm::vec3 clear_of_rim(const Section& section, const SectionPath& path, const glm::vec3& centre, const Plane& plane,
                       double step)
{
    // Search in growing squares, along the two axes that the normal is least inclined to.
    const int across = dominant_axis(plane.normal);
    const int u = (across + 1) % 3, v = (across + 2) % 3;
    glm::vec3 place = centre;
    for (int reach = 0;; ++reach)
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j) {
                if (std::max(std::abs(i), std::abs(j)) != reach) continue;
                place[u] = nearest_finite_float(double(centre[u]) + i * step) + 0.0f;
                place[v] = nearest_finite_float(double(centre[v]) + j * step) + 0.0f;
                if (!has_point_at(section, path, place)) return place;
            }
}

}  // namespace

std::vector<std::uint32_t> close_with_fan(SideBuilder& builder, Crossings& crossings, const Section& section,
                                          std::span<const SectionPath> paths, const glm::vec3& centre, double step,
                                          const Plane& plane, double uv_scale, std::uint32_t material)
{
    std::vector<std::uint32_t> path_of_triangle;
    IndexedMesh& mesh = builder.mesh;
    const PlaneFrame frame = PlaneFrame::of(plane.normal, uv_scale);
    const glm::vec3 normal(builder.side() == Side::negative ? plane.normal : -plane.normal);
    const auto cap_vertex = [&](const glm::vec3& p) { return Vertex{p, normal, frame.uv(p)}; };

    std::vector<std::uint32_t> order;
    const auto solid_of = [&](std::uint32_t path) { return section.edges[paths[path].edges.front()].solid; };
    order_by(order, paths.size(), solid_of);

    for (const std::uint32_t p : order) {
        const SectionPath& path = paths[p];
        if (!path.closed) continue;

        // The rim: one vertex for each point of the loop.
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const auto count = static_cast<std::uint32_t>(path.edges.size());
        for (const std::uint32_t e : path.edges) {
            const SectionEdge& edge = section.edges[e];
            const SectionPoint& point = section.points[edge.from];
            if (edge.crossing != kNone)
                builder.append_streams(crossings.triangles[edge.crossing], edge.from_corner);
            else
                builder.append_streams_of(builder.source().triangles[edge.triangle][edge.from_corner]);
            mesh.points.push_back(point.existing != kNone ? builder.point_of_existing(point.existing)
                                                          : builder.point_of_cut(crossings, point.cut_point));
            builder.append_vertex(cap_vertex(point.position));
        }
        for (VertexStream& stream : mesh.streams)
            for (std::uint32_t w = 0; w < stream.width; ++w) {
                double sum = 0.0;
                for (std::uint32_t i = 0; i < count; ++i)
                    sum += double(stream.values[std::size_t(first + i) * stream.width + w]);
                stream.values.push_back(static_cast<float>(sum / count));
            }
        mesh.points.push_back(builder.new_point());
        const std::uint32_t apex = builder.append_vertex(cap_vertex(clear_of_rim(section, path, centre, plane, step)));
        builder.fan_centres.push_back(apex);

        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t from = first + i, to = first + (i + 1) % count;
            // The cap of the negative side holds the edge as the surface of the positive side does; the cap of the
            // positive side holds its reverse.
            if (builder.side() == Side::negative)
                builder.add_triangle({apex, from, to}, kNoSource);
            else
                builder.add_triangle({apex, to, from}, kNoSource);
        }
        path_of_triangle.insert(path_of_triangle.end(), count, p);
        builder.close_group({0, 0, material, solid_of(p), TriangleKind::cap});
    }
    return path_of_triangle;
}

linear::ClosedSides FanClosing::close(BySide<SideBuilder>& builders, Crossings& crossings,
                                      const linear::LinkedSection& linked)
{
    if (!linked.with_caps) return {};
    const glm::vec3 centre = section_centre(linked.section);
    const FanFacts facts = measure_fan(linked.section, linked.paths, centre, linked.plane);
    linear::ClosedSides closed;
    closed.caps_exceed_section = caps_exceed_section(facts.excess, linked.area, facts.rim, linked.unit);
    for (SideBuilder& b : builders)
        closed.path_of_cap[b.side()] = close_with_fan(b, crossings, linked.section, linked.paths, centre, linked.unit,
                                                      linked.plane, linked.uv_scale, linked.material);
    return closed;
}

}  // namespace kerf::core::baseline
