#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "support/small_meshes.h"

namespace kerf::core::small_meshes {

/// Solids on a small lattice: copies, their insides out, such that collapse, tetrahedra on triangles of others, and
/// triangles with their backs. Closed: along each edge as many triangles run one way as the other.
inline TriangleSoup solids_with_common_triangles(std::mt19937& random)
{
    const auto below = [&](std::size_t bound) { return static_cast<std::size_t>(random()) % bound; };
    const std::size_t side = 2 + below(2);
    const auto place = [&] { return glm::vec3(float(below(side)), float(below(side)), float(below(side))); };
    TriangleSoup mesh = tetrahedron();
    for (std::size_t i = 1 + below(6); i > 0 && mesh.triangles.size() < 120; --i) {
        const Triangle& t = mesh.triangles[below(mesh.triangles.size())];
        const glm::vec3 a = mesh.vertices[t[0]].position, b = mesh.vertices[t[1]].position,
                        c = mesh.vertices[t[2]].position;
        switch (below(6)) {
            case 0:
                mesh = std::move(mesh) + cube(place(), 1.0f);
                break;
            case 1:
                mesh = mesh + (below(2) == 0 ? mesh : inside_out(mesh));
                break;
            case 2:
                mesh = std::move(mesh) + soup({a, b, c}, {{0, 1, 2}, {0, 2, 1}});
                break;
            case 3:
                mesh = std::move(mesh) +
                       soup({place(), place(), place(), place()}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}});
                break;
            default:
                mesh = std::move(mesh) + soup({a, b, c, place()}, {{0, 1, 2}, {1, 0, 3}, {2, 1, 3}, {0, 2, 3}});
        }
    }
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    return mesh;
}

/// Turns over a few triangles, or about half of them. False where no orienting can tell what was closed: the triangles
/// at an edge are copies of one another, and do not cancel any more.
inline bool turn_some_over(TriangleSoup& mesh, std::mt19937& random)
{
    const bool is_half = random() % 4 == 0;
    for (std::size_t i = is_half ? mesh.triangles.size() : 1 + random() % 4; i > 0; --i) {
        Triangle& t = mesh.triangles[is_half ? i - 1 : random() % mesh.triangles.size()];
        if (!is_half || random() % 2 == 0) std::swap(t[1], t[2]);
    }

    using Place = std::array<float, 3>;
    struct Edge
    {
        int balance = 0;
        std::set<Place> opposite;
    };
    std::map<std::pair<Place, Place>, Edge> edges;
    for (const Triangle& t : mesh.triangles) {
        std::array<Place, 3> at;
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::vec3& p = mesh.vertices[t[i]].position;
            at[i] = {p.x, p.y, p.z};
        }
        if (at[0] == at[1] || at[1] == at[2] || at[2] == at[0]) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const Place &a = at[i], &b = at[(i + 1) % 3];
            Edge& edge = edges[std::minmax(a, b)];
            edge.balance += a < b ? 1 : -1;
            edge.opposite.insert(at[(i + 2) % 3]);
        }
    }
    return std::none_of(edges.begin(), edges.end(), [](const auto& entry) {
        return entry.second.balance != 0 && entry.second.opposite.size() == 1;
    });
}

}  // namespace kerf::core::small_meshes
