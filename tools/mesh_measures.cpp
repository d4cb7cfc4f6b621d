#include "tools/mesh_measures.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace kerf::tools {

double volume_of(const FlatMesh& mesh)
{
    const glm::dvec3 origin = mesh.bounds().centre();
    double six = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const auto corner = [&](std::size_t i) { return glm::dvec3(mesh.vertices[t[i]].position) - origin; };
        six += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    return six / 6.0;
}

double area_of(const FlatMesh& mesh)
{
    double twice = 0.0;
    for (const Triangle& t : mesh.triangles) {
        const auto corner = [&](std::size_t i) { return glm::dvec3(mesh.vertices[t[i]].position); };
        twice += glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
    return twice / 2.0;
}

std::uint64_t degenerate_triangles(const FlatMesh& mesh)
{
    return static_cast<std::uint64_t>(
        std::count_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
            const glm::vec3 &a = mesh.vertices[t[0]].position, &b = mesh.vertices[t[1]].position,
                            &c = mesh.vertices[t[2]].position;
            return a == b || b == c || c == a;
        }));
}

std::uint64_t vertices_without_number(const FlatMesh& mesh)
{
    return static_cast<std::uint64_t>(std::count_if(mesh.vertices.begin(), mesh.vertices.end(), [](const Vertex& v) {
        for (const float number :
             {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.uv.x, v.uv.y})
            if (!std::isfinite(number)) return true;
        return false;
    }));
}

double cap_area_of(const FlatMesh& mesh, std::uint32_t material, const glm::dvec3& normal)
{
    double twice = 0.0;
    for (const TriangleGroup& group : mesh.groups) {
        if (group.kind != TriangleKind::cap || group.material != material) continue;
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) {
            const auto corner = [&](std::size_t i) { return glm::dvec3(mesh.vertices[mesh.triangles[t][i]].position); };
            twice += std::abs(glm::dot(normal, glm::cross(corner(1) - corner(0), corner(2) - corner(0))));
        }
    }
    return 0.5 * twice;
}

double overhang_of(const FlatMesh& mesh, const Plane& plane, double sign)
{
    double worst = 0.0;
    for (const Vertex& v : mesh.vertices) worst = std::max(worst, -sign * plane.distance(v.position));
    return worst;
}

}  // namespace kerf::tools
