#include "linear/split_points.h"

#include <cmath>
#include <vector>

#include "common/geometry/pair_table.h"
#include "common/repair/edge_pairing.h"
#include "common/repair/vertex_fans.h"

namespace kerf::core::linear {

namespace {

/// Triangles around some points, linked to their neighbours.
struct Neighbourhood
{
    std::vector<std::uint32_t> triangles;  ///< of the mesh
    LinkedSurface surface;                 ///< of them, by point
    std::vector<NonmanifoldEdge> crowded;  ///< edges of more than two of them; not linked yet
};

std::vector<bool> points_near(const IndexedMesh& mesh, const Plane& plane, double noise)
{
    std::vector<bool> is_near(mesh.point_count, false);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        if (std::abs(plane.signed_distance(mesh.vertices[v].position)) <= noise) is_near[mesh.points[v]] = true;
    return is_near;
}

Neighbourhood neighbourhood_of(const IndexedMesh& mesh, const std::vector<bool>& is_near)
{
    Neighbourhood around;
    LinkedSurface& surface = around.surface;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Triangle corners{mesh.points[a], mesh.points[b], mesh.points[c]};
        if (!is_near[corners[0]] && !is_near[corners[1]] && !is_near[corners[2]]) continue;
        around.triangles.push_back(t);
        surface.corners.push_back(corners);
    }
    surface.opposite.assign(3 * surface.corners.size(), kNone);
    surface.flipped.assign(surface.corners.size(), 0);

    HalfedgesByEdge(mesh.point_count, surface.corners).for_each([&](std::span<const HalfedgesByEdge::Entry> edge) {
        if (edge.size() == 2 && surface.start(edge[0].halfedge) != surface.start(edge[1].halfedge)) {
            surface.link(edge[0].halfedge, edge[1].halfedge);
        } else if (edge.size() > 2) {
            NonmanifoldEdge& sides = around.crowded.emplace_back();
            for (const HalfedgesByEdge::Entry& side : edge) sides.push_back(side.halfedge);
        }
    });
    return around;
}

VertexFans fans_of(const IndexedMesh& mesh, Neighbourhood& around)
{
    if (!around.crowded.empty()) {
        std::vector<glm::vec3> positions(mesh.point_count);
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) positions[mesh.points[v]] = mesh.vertices[v].position;
        const std::vector<std::uint32_t> one_patch(around.surface.corners.size(), 0);
        pair_at_edges(around.surface, around.crowded, positions, one_patch);
    }
    return find_vertex_fans(around.surface, around.crowded);
}

/// Appends a copy of a vertex that lies at `point`.
std::uint32_t copy_vertex(IndexedMesh& mesh, std::uint32_t vertex, std::uint32_t point)
{
    const Vertex copied = mesh.vertices[vertex];
    mesh.vertices.push_back(copied);
    mesh.points.push_back(point);
    for (VertexStream& stream : mesh.streams)
        for (std::uint32_t w = 0; w < stream.width; ++w) {
            const float value = stream.values[std::size_t(vertex) * stream.width + w];
            stream.values.push_back(value);
        }
    return static_cast<std::uint32_t>(mesh.vertices.size() - 1);
}

void drop_unused(IndexedMesh& mesh)
{
    std::vector<std::uint32_t> new_vertex(mesh.vertices.size(), kNone), new_point(mesh.point_count, kNone);
    for (const Triangle& t : mesh.triangles)
        for (const std::uint32_t v : t) new_vertex[v] = 0;
    std::uint32_t vertices = 0, points = 0;
    for (std::uint32_t v = 0; v < new_vertex.size(); ++v) {
        if (new_vertex[v] == kNone) continue;
        new_vertex[v] = vertices++;
        std::uint32_t& point = new_point[mesh.points[v]];
        if (point == kNone) point = points++;
    }
    if (vertices == mesh.vertices.size() && points == mesh.point_count) return;
    for (std::uint32_t v = 0; v < new_vertex.size(); ++v) {
        const std::uint32_t to = new_vertex[v];
        if (to == kNone) continue;
        mesh.vertices[to] = mesh.vertices[v];
        mesh.points[to] = new_point[mesh.points[v]];
        for (VertexStream& stream : mesh.streams)
            for (std::size_t w = 0; w < stream.width; ++w)
                stream.values[std::size_t(to) * stream.width + w] = stream.values[std::size_t(v) * stream.width + w];
    }
    mesh.vertices.resize(vertices);
    mesh.points.resize(vertices);
    mesh.point_count = points;
    for (VertexStream& stream : mesh.streams) stream.values.resize(std::size_t(vertices) * stream.width);
    for (Triangle& t : mesh.triangles)
        for (std::uint32_t& v : t) v = new_vertex[v];
}

}  // namespace

void split_points(IndexedMesh& mesh, const Plane& plane, double noise)
{
    std::vector<bool> is_near = points_near(mesh, plane, noise);
    Neighbourhood around = neighbourhood_of(mesh, is_near);
    // A crowded edge may divide the fan at its other end, too.
    bool reaches_farther = false;
    for (const NonmanifoldEdge& edge : around.crowded)
        for (const std::uint32_t end : {around.surface.start(edge.front()), around.surface.end(edge.front())}) {
            reaches_farther = reaches_farther || !is_near[end];
            is_near[end] = true;
        }
    if (reaches_farther) around = neighbourhood_of(mesh, is_near);
    const VertexFans fans = fans_of(mesh, around);

    // The first fan of a point keeps the point, the first fan of a vertex the vertex.
    PairTable point_of_fan, vertex_in_fan;
    std::vector<bool> has_fan(mesh.point_count, false), has_point(mesh.vertices.size(), false);
    for (std::size_t i = 0; i < around.triangles.size(); ++i)
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::uint32_t old_point = around.surface.corners[i][c];
            if (!is_near[old_point]) continue;
            const std::uint32_t fan = fans.fan[3 * i + c];
            std::uint32_t& point = point_of_fan(fan, 0);
            if (point == kNone) {
                point = has_fan[old_point] ? mesh.point_count++ : old_point;
                has_fan[old_point] = true;
            }
            std::uint32_t& corner = mesh.triangles[around.triangles[i]][c];
            std::uint32_t& vertex = vertex_in_fan(corner, point);
            if (vertex == kNone) {
                vertex = has_point[corner] ? copy_vertex(mesh, corner, point) : corner;
                if (!has_point[corner]) mesh.points[corner] = point;
                has_point[corner] = true;
            }
            corner = vertex;
        }
    drop_unused(mesh);
}

}  // namespace kerf::core::linear
