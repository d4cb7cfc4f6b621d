#include "common/indexed_mesh.h"

#include <cmath>

namespace kerf {

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

std::string check_vertices(const IndexedMesh& mesh)
{
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (!is_usable(mesh.vertices[i].position))
            return "vertex " + std::to_string(i) + " has a coordinate that is not finite, or is -0";
    if (mesh.points.size() != mesh.vertices.size())
        return "there are " + std::to_string(mesh.vertices.size()) + " vertices but " +
               std::to_string(mesh.points.size()) + " point ids";
    constexpr std::uint32_t kNone = kNoSource;
    std::vector<std::uint32_t> vertex_of_point(mesh.point_count, kNone);
    for (std::uint32_t i = 0; i < mesh.points.size(); ++i) {
        const std::uint32_t point = mesh.points[i];
        if (point >= mesh.point_count)
            return "vertex " + std::to_string(i) + " has point id " + std::to_string(point) + ", but there are only " +
                   std::to_string(mesh.point_count) + " points";
        std::uint32_t& first = vertex_of_point[point];
        if (first == kNone)
            first = i;
        else if (mesh.vertices[first].position != mesh.vertices[i].position)
            return "vertices " + std::to_string(first) + " and " + std::to_string(i) +
                   " share a point but not their position";
    }
    for (std::uint32_t point = 0; point < mesh.point_count; ++point)
        if (vertex_of_point[point] == kNone) return "point " + std::to_string(point) + " has no vertex";
    for (const VertexStream& stream : mesh.streams)
        if (stream.width == 0 || stream.values.size() != mesh.vertices.size() * stream.width)
            return "stream '" + stream.name + "' does not have " + std::to_string(stream.width) + " values per vertex";
    return {};
}

std::string check_triangles(const IndexedMesh& mesh)
{
    if (mesh.triangles.empty()) return "the mesh has no triangles";
    if (mesh.triangles.size() > std::numeric_limits<std::uint32_t>::max() / 3)
        return "the mesh has more than 2^32 corners";
    if (mesh.sources.size() != mesh.triangles.size()) return "there is not one source for each triangle";
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& [a, b, c] = mesh.triangles[i];
        const std::size_t n = mesh.vertices.size();
        if (a >= n || b >= n || c >= n) return "triangle " + std::to_string(i) + " has a vertex index out of range";
        const std::uint32_t p = mesh.points[a], q = mesh.points[b], r = mesh.points[c];
        if (p == q || q == r || r == p) return "triangle " + std::to_string(i) + " has two corners in one point";
    }
    return {};
}

std::string check_groups(const IndexedMesh& mesh)
{
    std::uint64_t covered = 0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.first != covered) return "the triangle groups do not follow one another";
        if (group.material >= mesh.materials.size()) return "a triangle group names a material that does not exist";
        covered += group.count;
    }
    if (covered != mesh.triangles.size()) return "the triangle groups do not cover all triangles";
    return {};
}

}  // namespace

std::string check(const IndexedMesh& mesh)
{
    if (std::string error = check_vertices(mesh); !error.empty()) return error;
    if (std::string error = check_triangles(mesh); !error.empty()) return error;
    return check_groups(mesh);
}

}  // namespace kerf
