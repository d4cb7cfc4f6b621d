// Cube, icosphere, sphere, cylinder, cone and pedestal.

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numbers>

#include "maker/lathe.h"
#include "maker/models.h"

namespace kerf::maker {

PolyMesh make_cube()
{
    PolyMesh mesh;
    for (int i = 0; i < 8; ++i) mesh.add_point({i & 1 ? 0.75 : -0.75, i & 2 ? 0.75 : -0.75, i & 4 ? 0.75 : -0.75});
    const std::array<std::array<int, 4>, 6> sides{
        {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}};
    for (const auto& side : sides)
        mesh.add_facet({side.begin(), side.end()}, "paint", {{0, 0}, {1, 0}, {1, 1}, {0, 1}});
    return mesh;
}

PolyMesh make_icosphere()
{
    PolyMesh mesh;
    const double g = std::numbers::phi;
    // The twelve corners are those of three golden rectangles.
    for (const double a : {-1.0, 1.0})
        for (const double b : {-g, g}) {
            mesh.add_point({0, a, b});
            mesh.add_point({a, b, 0});
            mesh.add_point({b, 0, a});
        }
    for (glm::dvec3& p : mesh.points) p = glm::normalize(p);
    const auto at = [&](int p) { return mesh.points[std::size_t(p)]; };
    std::map<std::array<int, 2>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [found, is_new] = middles.try_emplace({std::min(a, b), std::max(a, b)}, 0);
        if (is_new) found->second = mesh.add_point(glm::normalize(at(a) + at(b)));
        return found->second;
    };
    const auto add = [&](int a, int b, int c) {
        mesh.add_facet({a, b, c}, "paint", {{0, 0}, {1, 0}, {0.5, std::sqrt(0.75)}});
    };
    constexpr double kEdge = 1.1;  // the icosahedron's edge is 1.05 radii, its next distance 1.70
    for (int a = 0; a < 12; ++a)
        for (int b = a + 1; b < 12; ++b)
            for (int c = b + 1; c < 12; ++c) {
                if (glm::distance(at(a), at(b)) > kEdge || glm::distance(at(b), at(c)) > kEdge ||
                    glm::distance(at(a), at(c)) > kEdge)
                    continue;
                const bool outwards = glm::dot(glm::cross(at(b) - at(a), at(c) - at(a)), at(a)) > 0;
                const int p = a, q = outwards ? b : c, r = outwards ? c : b;
                const int pq = middle(p, q), qr = middle(q, r), rp = middle(r, p);
                add(p, pq, rp);
                add(pq, q, qr);
                add(rp, qr, r);
                add(pq, qr, rp);
            }
    return mesh;
}

PolyMesh make_sphere()
{
    PolyMesh mesh;
    constexpr int kSegments = 20, kRings = 20;
    Lathe lathe(mesh, kSegments, "paint");
    lathe.smooth(1);
    Ring below;
    for (int k = 1; k < kRings; ++k) {
        const double latitude = std::numbers::pi * (double(k) / kRings - 0.5);
        const Ring ring = lathe.ring(std::cos(latitude), std::sin(latitude), double(k) / kRings);
        if (k == 1)
            lathe.fan(ring, -1.0, false);
        else
            lathe.band(below, ring);
        below = ring;
    }
    lathe.fan(below, 1.0, true);
    return mesh;
}

PolyMesh make_cylinder()
{
    PolyMesh mesh;
    Lathe lathe(mesh, 32, "paint");
    const Ring bottom = lathe.ring(0.75, -1.0, 0.0), top = lathe.ring(0.75, 1.0, 2.0);
    lathe.disc(bottom, false);
    lathe.band(bottom, top);
    lathe.disc(top, true);
    return mesh;
}

PolyMesh make_cone()
{
    PolyMesh mesh;
    Lathe lathe(mesh, 32, "paint");
    const Ring bottom = lathe.ring(0.9, -1.0, 0.0);
    lathe.disc(bottom, false);
    lathe.fan(bottom, 1.0, true);
    return mesh;
}

PolyMesh make_pedestal()
{
    PolyMesh mesh;
    Lathe lathe(mesh, 4, "stone");
    const std::array<Profile::Point, 6> profile{
        {{0.7, -1.0}, {0.7, -0.72}, {0.44, -0.5}, {0.38, 0.52}, {0.62, 0.74}, {0.62, 1.0}}};
    std::array<Ring, 6> rings;
    for (std::size_t k = 0; k < profile.size(); ++k) {
        const auto [radius, height] = profile[k];
        rings[k] = lathe.ring(
            [&lathe, r = radius * std::sqrt(2.0), h = height](int i) { return lathe.at(r, h, i + 0.5); }, height);
    }
    lathe.disc(rings.front(), false);
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) lathe.band(rings[k], rings[k + 1]);
    lathe.disc(rings.back(), true);
    return mesh;
}

}  // namespace kerf::maker
