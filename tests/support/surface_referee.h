#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "common/mesh/indexed_mesh.h"

// What IndexedMesh promises about edges and points, checked with maps and sets: slow, and without a line of the code
// that it judges.

namespace kerf::core::surface_referee {

struct Surface
{
    std::uint64_t boundary_edges = 0;
    std::string fault;  ///< empty, or the first promise that is broken
};

inline Surface judge(const IndexedMesh& mesh)
{
    Surface surface;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> triangle_at;  // directed edge by points
    std::map<std::uint32_t, std::vector<std::uint32_t>> triangles_at;
    const auto points_of = [&](std::uint32_t t) {
        const auto& [a, b, c] = mesh.triangles[t];
        return std::array{mesh.points[a], mesh.points[b], mesh.points[c]};
    };
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto p = points_of(t);
        for (std::size_t i = 0; i < 3; ++i) {
            if (!triangle_at.insert({{p[i], p[(i + 1) % 3]}, t}).second) surface.fault = "a directed edge occurs twice";
            triangles_at[p[i]].push_back(t);
        }
    }
    for (const auto& [edge, t] : triangle_at)
        surface.boundary_edges += !triangle_at.contains({edge.second, edge.first});
    for (const auto& [point, triangles] : triangles_at) {
        std::set<std::uint32_t> reached{triangles.front()};
        std::vector<std::uint32_t> stack{triangles.front()};
        while (!stack.empty()) {
            const auto p = points_of(stack.back());
            stack.pop_back();
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t from = p[i], to = p[(i + 1) % 3];
                const auto across = triangle_at.find({to, from});
                if ((from != point && to != point) || across == triangle_at.end()) continue;
                if (reached.insert(across->second).second) stack.push_back(across->second);
            }
        }
        if (reached.size() != triangles.size()) surface.fault = "the triangles around a point are not one fan";
    }
    if (triangles_at.size() != mesh.point_count) surface.fault = "a point has no triangle";
    std::set<std::uint32_t> used;
    for (const Triangle& triangle : mesh.triangles) used.insert(triangle.begin(), triangle.end());
    if (used.size() != mesh.vertices.size()) surface.fault = "a vertex has no triangle";
    return surface;
}

}  // namespace kerf::core::surface_referee
