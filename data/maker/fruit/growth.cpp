#include "maker/fruit/growth.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace kerf::maker {
namespace {

using std::numbers::pi;

/// `v` turned as the shortest turn takes +y to `to`, a unit vector that is not -y (Rodrigues).
glm::dvec3 turned_from_y(const glm::dvec3& v, const glm::dvec3& to)
{
    const glm::dvec3 y{0, 1, 0}, axis = glm::cross(y, to);
    const double cosine = to.y;
    return v * cosine + glm::cross(axis, v) + axis * (glm::dot(axis, v) / (1.0 + cosine));
}

}  // namespace

std::vector<double> even_angles(double from, double to, int bands)
{
    std::vector<double> angles;
    for (int i = 0; i <= bands; ++i) angles.push_back(from + (to - from) * i / bands);
    return angles;
}

SkinRings grow_skin(PolyMesh& mesh, Lathe& lathe, int segments, Outline outline, const std::vector<double>& polars)
{
    SkinRings rings;
    for (std::size_t k = 0; k < polars.size(); ++k) {
        const auto place = [&](int i) { return on_outline(outline, polars[k], 2.0 * pi * i / segments); };
        if (k == 0) {
            rings.lowest = rings.highest = lathe.ring(place, 0.0);
            continue;
        }
        const glm::dvec3 before = mesh.points[std::size_t(rings.highest.points[0])];
        const Ring above = lathe.ring(place, rings.highest.v + glm::distance(before, place(0)));
        lathe.band(rings.highest, above);
        rings.highest = above;
    }
    return rings;
}

Ring grow_tube(Lathe& lathe, int segments, const Ring& from, const std::vector<Station>& stations)
{
    Ring below = from;
    for (std::size_t k = 0; k < stations.size(); ++k) {
        const Station& here = stations[k];
        const glm::dvec3 before = k > 0 ? stations[k - 1].centre : here.centre;
        const glm::dvec3 after = k + 1 < stations.size() ? stations[k + 1].centre : here.centre;
        const glm::dvec3 axis = after == before ? glm::dvec3{0, 1, 0} : glm::normalize(after - before);
        const double length = k > 0 ? glm::distance(here.centre, before) : 0.02;
        const Ring above = lathe.ring(
            [&](int i) {
                const double turn = 2.0 * pi * i / segments;
                return here.centre + here.radius * turned_from_y({std::cos(turn), 0, -std::sin(turn)}, axis);
            },
            below.v + length);
        lathe.band(below, above);
        below = above;
    }
    return below;
}

void grow_leaf(PolyMesh& mesh, const Ring& lower, const Ring& upper, int i, const std::vector<LeafStation>& stations,
               const glm::dvec3& tip, std::string_view material, int smoothing)
{
    const std::size_t n = lower.points.size(), first = std::size_t(i);
    // Counter-clockwise seen from outside: along the lower side, back along the upper one.
    std::array<int, 6> before{lower.points[first % n],       lower.points[(first + 1) % n],
                              lower.points[(first + 2) % n], upper.points[(first + 2) % n],
                              upper.points[(first + 1) % n], upper.points[first % n]};
    constexpr std::array<double, 6> kAcross{0.0, 0.5, 1.0, 1.0, 0.5, 0.0};
    // Lower face, right edge, upper face, left edge: sharp against one another.
    constexpr std::array<int, 6> kGroup{0, 0, 1, 2, 2, 3};
    const auto add = [&](std::size_t a, std::size_t b, int c, int d, double v0, double v1) {
        const double ua = kAcross[a], ub = kAcross[b];
        if (c == d)
            mesh.add_facet({before[a], before[b], c}, material,
                           {{ua, v0}, {ub + (ua == ub ? 0.02 : 0.0), v0}, {0.5, v1}}, smoothing + kGroup[a]);
        else
            mesh.add_facet({before[a], before[b], c, d}, material,
                           {{ua, v0}, {ub + (ua == ub ? 0.02 : 0.0), v0}, {ub + (ua == ub ? 0.02 : 0.0), v1}, {ua, v1}},
                           smoothing + kGroup[a]);
    };
    double v = 0.0;
    for (std::size_t k = 0; k < stations.size(); ++k) {
        const LeafStation& here = stations[k];
        const glm::dvec3 last = k > 0 ? stations[k - 1].centre : here.centre;
        const glm::dvec3 next = k + 1 < stations.size() ? stations[k + 1].centre : tip;
        const glm::dvec3 right = glm::normalize(glm::cross(here.up, next - last));
        const glm::dvec3 edge = here.up * (0.35 * here.half_height), middle = here.up * here.half_height;
        const glm::dvec3 left_edge = here.centre - right * here.half_width + here.up * here.fold;
        const glm::dvec3 right_edge = here.centre + right * here.half_width + here.up * here.fold;
        const std::array<int, 6> ring{mesh.add_point(left_edge - edge),     mesh.add_point(here.centre - middle),
                                      mesh.add_point(right_edge - edge),    mesh.add_point(right_edge + edge),
                                      mesh.add_point(here.centre + middle), mesh.add_point(left_edge + edge)};
        const double length = k > 0 ? glm::distance(here.centre, last) : 0.05;
        for (std::size_t a = 0; a < 6; ++a) {
            const std::size_t b = (a + 1) % 6;
            add(a, b, ring[b], ring[a], v, v + length);
        }
        v += length;
        before = ring;
    }
    const int point = mesh.add_point(tip);
    for (std::size_t a = 0; a < 6; ++a) add(a, (a + 1) % 6, point, point, v, v + 0.1);
}

void add_cavity(PolyMesh& mesh, const PolyMesh& source)
{
    const int first = int(mesh.points.size());
    mesh.points.insert(mesh.points.end(), source.points.begin(), source.points.end());
    for (Facet facet : source.facets) {
        for (int& p : facet.points) p += first;
        std::reverse(facet.points.begin(), facet.points.end());
        std::reverse(facet.uvs.begin(), facet.uvs.end());
        mesh.facets.push_back(std::move(facet));
    }
}

}  // namespace kerf::maker
