#include "baseline/fan.h"

#include <algorithm>
#include <numeric>

namespace kerf::baseline {

glm::vec3 section_centre(const Section& section)
{
    glm::dvec3 sum{0.0};
    for (const SectionEdge& edge : section.edges) sum += glm::dvec3(section.points[edge.from].position);
    const glm::vec3 centre(sum / std::max<double>(1.0, double(section.edges.size())));
    return centre + 0.0f;  // -0 does not occur in a mesh
}

void close_with_fan(SideBuilder& builder, Crossings& crossings, const Section& section,
                    std::span<const SectionPath> paths, const glm::vec3& centre, const Plane& plane,
                    std::uint32_t material)
{
    IndexedMesh& mesh = builder.mesh;
    const PlaneFrame frame = PlaneFrame::of(plane.normal);
    const glm::vec3 normal(builder.side() == Side::negative ? plane.normal : -plane.normal);
    const auto cap_vertex = [&](const glm::vec3& p) {
        return Vertex{p, normal, glm::vec2(glm::dot(frame.u, glm::dvec3(p)), glm::dot(frame.v, glm::dvec3(p)))};
    };

    std::vector<std::uint32_t> order(paths.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto solid_of = [&](std::uint32_t path) { return section.edges[paths[path].edges.front()].solid; };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return solid_of(a) < solid_of(b); });

    for (const std::uint32_t p : order) {
        const SectionPath& path = paths[p];
        if (!path.closed) continue;

        // The rim: one vertex for each point of the loop.
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        const auto count = static_cast<std::uint32_t>(path.edges.size());
        std::uint32_t apex = kNone;  // a rim vertex that lies exactly at the centre takes its place
        for (const std::uint32_t e : path.edges) {
            const SectionEdge& edge = section.edges[e];
            const SectionPoint& point = section.points[edge.from];
            if (edge.crossing != kNone)
                builder.append_streams(crossings.triangles[edge.crossing], edge.from_corner);
            else
                builder.append_streams_of(builder.source().triangles[edge.triangle][edge.from_corner]);
            if (same_position(point.position, centre)) apex = static_cast<std::uint32_t>(mesh.vertices.size());
            mesh.points.push_back(point.existing != kNone ? builder.point_of_existing(point.existing)
                                                          : builder.point_of_cut(crossings, point.cut_point));
            mesh.vertices.push_back(cap_vertex(point.position));
        }
        if (apex == kNone) {
            apex = static_cast<std::uint32_t>(mesh.vertices.size());
            for (VertexStream& stream : mesh.streams)
                for (std::uint32_t w = 0; w < stream.width; ++w) {
                    double sum = 0.0;
                    for (std::uint32_t i = 0; i < count; ++i)
                        sum += double(stream.values[std::size_t(first + i) * stream.width + w]);
                    stream.values.push_back(static_cast<float>(sum / count));
                }
            mesh.points.push_back(builder.new_point());
            mesh.vertices.push_back(cap_vertex(centre));
            builder.fan_centres.push_back(apex);
        }

        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t from = first + i, to = first + (i + 1) % count;
            if (from == apex || to == apex) continue;
            // The negative side's cap holds the edge as the positive side's surface does, the positive side's its
            // reverse.
            if (builder.side() == Side::negative)
                builder.add_triangle({apex, from, to}, kNoSource);
            else
                builder.add_triangle({apex, to, from}, kNoSource);
        }
        builder.close_group({0, 0, material, solid_of(p), TriangleKind::cap});
    }
}

}  // namespace kerf::baseline
