#pragma once

#include <algorithm>
#include <random>

#include "common/small_meshes.h"

namespace kerf::small_meshes {

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

}  // namespace kerf::small_meshes
