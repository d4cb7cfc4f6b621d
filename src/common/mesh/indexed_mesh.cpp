#include "common/mesh/indexed_mesh.h"

#include <algorithm>
#include <cmath>

#include "common/support/reason.h"

namespace kerf::core {

namespace {

bool is_negative_zero(float value)
{
    return value == 0.0f && std::signbit(value);
}

bool is_usable(const glm::vec3& p)
{
    for (int axis = 0; axis < 3; ++axis)
        if (!std::isfinite(p[axis]) || is_negative_zero(p[axis])) return false;
    return true;
}

bool are_finite(const glm::vec3& normal, const glm::vec2& uv)
{
    return std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z) && std::isfinite(uv.x) &&
           std::isfinite(uv.y);
}

std::string check_points(const IndexedMesh& mesh)
{
    const std::size_t n = mesh.vertices.size();
    if (mesh.points.size() != n)
        return "there are " + std::to_string(n) + " vertices but " + std::to_string(mesh.points.size()) +
               " point ids; give each vertex one";
    if (mesh.point_count > n)
        return "there are " + std::to_string(mesh.point_count) + " points but only " + std::to_string(n) +
               " vertices; give each point a vertex";
    std::vector<std::uint32_t> vertex_of_point(mesh.point_count, kNoSource);
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t point = mesh.points[i];
        if (point >= mesh.point_count)
            return "vertex " + std::to_string(i) + " has point id " + std::to_string(point) +
                   but_there_are_only(mesh.point_count);
        std::uint32_t& first = vertex_of_point[point];
        if (first == kNoSource)
            first = i;
        else if (mesh.vertices[first].position != mesh.vertices[i].position)
            return "vertices " + std::to_string(first) + " and " + std::to_string(i) +
                   " share a point but not their position; give each a point of its own";
    }
    for (std::uint32_t point = 0; point < mesh.point_count; ++point)
        if (vertex_of_point[point] == kNoSource)
            return "point " + std::to_string(point) + " has no vertex; use every id below the number of points";
    return {};
}

std::string check_vertices(const IndexedMesh& mesh)
{
    const std::size_t n = mesh.vertices.size();
    if (n >= kNoSource) return "the mesh has more than 2^32 vertices; divide it into several";
    for (std::size_t i = 0; i < n; ++i) {
        if (!is_usable(mesh.vertices[i].position))
            return "vertex " + std::to_string(i) + " has a coordinate that is not finite, or is -0; give it a number";
        if (!are_finite(mesh.vertices[i].normal, mesh.vertices[i].uv))
            return "vertex " + std::to_string(i) + " has a normal or uv that is not finite; give it a number";
    }
    if (std::string error = check_points(mesh); !error.empty()) return error;
    for (const VertexStream& stream : mesh.streams)
        if (stream.width == 0 || stream.values.size() / stream.width != n || stream.values.size() % stream.width != 0)
            return "stream " + in_quotes(stream.name) + " does not have " + std::to_string(stream.width) +
                   " values for each vertex, one at least; complete it or leave it out";
    return {};
}

std::string check_triangles(const IndexedMesh& mesh)
{
    if (mesh.triangles.empty()) return "the mesh has no triangles; give it one at least";
    if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3)
        return "the mesh has more than 2^32 corners; divide it into several";
    if (mesh.sources.size() != mesh.triangles.size())
        return "there is not one source for each triangle; give each one, or kNoSource";
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        for (const std::uint32_t v : {a, b, c})
            if (v >= mesh.vertices.size())
                return "triangle " + std::to_string(i) + " refers to vertex " + std::to_string(v) +
                       but_there_are_only(mesh.vertices.size());
        const glm::vec3 &p = mesh.vertices[a].position, &q = mesh.vertices[b].position, &r = mesh.vertices[c].position;
        if (p == q || q == r || r == p)
            return "triangle " + std::to_string(i) + " has two corners at one position; take it out";
    }
    return {};
}

std::string check_groups(const IndexedMesh& mesh)
{
    std::uint64_t covered = 0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.first != covered)
            return "the triangle groups do not follow one another; begin each where the one before ends";
        if (group.material >= mesh.materials.size())
            return "a triangle group refers to material " + std::to_string(group.material) +
                   but_there_are_only(mesh.materials.size());
        if (group.kind != TriangleKind::surface && group.kind != TriangleKind::cap)
            return "a triangle group is neither surface nor cap; make it one of them";
        covered += group.count;
    }
    if (covered != mesh.triangles.size())
        return "the triangle groups do not cover the triangles, all and no more; end the last where the triangles end";
    return {};
}

}  // namespace

bool are_in_range(std::span<const Triangle> triangles, std::size_t vertex_count)
{
    return std::all_of(triangles.begin(), triangles.end(), [=](const Triangle& t) {
        return std::max({t[0], t[1], t[2]}) < vertex_count;
    });
}

std::string check(const IndexedMesh& mesh)
{
    if (std::string error = check_vertices(mesh); !error.empty()) return error;
    if (std::string error = check_triangles(mesh); !error.empty()) return error;
    return check_groups(mesh);
}

}  // namespace kerf::core
