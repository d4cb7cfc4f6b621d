#include "linear/crossing.h"

#include <algorithm>

namespace kerf::core::linear {

namespace {

const CutPoint& cut_point_of(const TriangleSplit& split, std::uint8_t code)
{
    return code == TriangleSplit::kCutNext ? split.cut_next : split.cut_previous;
}

}  // namespace

std::array<std::uint32_t, 2> cut_edge_vertices(const IndexedMesh& mesh, const CrossingTriangle& crossing,
                                               std::uint8_t code)
{
    const Triangle& t = mesh.triangles[crossing.triangle];
    const std::uint8_t lone = crossing.split.lone;
    if (code == TriangleSplit::kCutNext) return {t[lone], t[(lone + 1u) % 3]};
    return {t[(lone + 2u) % 3], t[lone]};
}

Vertex corner_vertex(const IndexedMesh& mesh, const CrossingTriangle& crossing, std::uint8_t code)
{
    if (code < 3) return mesh.vertices[mesh.triangles[crossing.triangle][code]];
    const auto [a, b] = cut_edge_vertices(mesh, crossing, code);
    return interpolate(cut_point_of(crossing.split, code), mesh.vertices[a], mesh.vertices[b]);
}

void corner_stream(const IndexedMesh& mesh, const VertexStream& stream, const CrossingTriangle& crossing,
                   std::uint8_t code, float* result)
{
    const auto values = [&](std::uint32_t vertex) { return stream.values.data() + std::size_t(vertex) * stream.width; };
    if (code < 3) {
        std::copy_n(values(mesh.triangles[crossing.triangle][code]), stream.width, result);
        return;
    }
    const auto [a, b] = cut_edge_vertices(mesh, crossing, code);
    interpolate(cut_point_of(crossing.split, code), values(a), values(b), result, stream.width);
}

void split_crossing_triangles(const IndexedMesh& mesh, const Plane& plane, Crossings& crossings)
{
    crossings.cut_point_of_edge.reset(crossings.triangles.size() + crossings.triangles.size() / 2);
    crossings.cut_points.clear();
    crossings.cut_points.reserve(crossings.triangles.size() + crossings.triangles.size() / 2);

    const auto cut_point = [&](std::uint32_t a, std::uint32_t b) {
        const std::uint32_t p = mesh.points[a], q = mesh.points[b];
        std::uint32_t& id = crossings.cut_point_of_edge(std::min(p, q), std::max(p, q));
        if (id == kNone) id = crossings.cut_points.add();
        return id;
    };

    for (CrossingTriangle& crossing : crossings.triangles) {
        const Triangle& t = mesh.triangles[crossing.triangle];
        const std::array<glm::vec3, 3> p{mesh.vertices[t[0]].position, mesh.vertices[t[1]].position,
                                         mesh.vertices[t[2]].position};
        crossing.split =
            split_triangle(p, {plane.signed_distance(p[0]), plane.signed_distance(p[1]), plane.signed_distance(p[2])});

        const TriangleSplit& split = crossing.split;
        const std::uint32_t lone = t[split.lone], next = t[(split.lone + 1u) % 3], previous = t[(split.lone + 2u) % 3];
        crossing.cut_next = cut_point(lone, next);
        crossing.cut_previous = cut_point(previous, lone);
        if (split.next_code < 3) crossings.cut_points.attach(crossing.cut_next, mesh.points[t[split.next_code]]);
        if (split.previous_code < 3)
            crossings.cut_points.attach(crossing.cut_previous, mesh.points[t[split.previous_code]]);
        else if (split.previous_code == TriangleSplit::kCutNext)
            crossings.cut_points.merge(crossing.cut_next, crossing.cut_previous);
    }
}

}  // namespace kerf::core::linear
