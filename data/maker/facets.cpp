#include "maker/facets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <utility>

#include "maker/triangulate.h"

namespace kerf::maker {

void fold_bent_facets(PolyMesh& mesh, double degrees)
{
    std::vector<Facet> folded;
    for (Facet& facet : mesh.facets) {
        if (facet.points.size() == 4) {
            std::vector<glm::dvec3> loop;
            for (const int p : facet.points) loop.push_back(mesh.points[std::size_t(p)]);
            const auto halves = triangulate(loop);
            const auto half = [&](std::size_t h) {
                Facet part = facet;
                part.points.clear();
                part.uvs.clear();
                for (const int corner : halves[h]) {
                    part.points.push_back(facet.points[std::size_t(corner)]);
                    if (!facet.uvs.empty()) part.uvs.push_back(facet.uvs[std::size_t(corner)]);
                }
                return part;
            };
            const Facet first = half(0), second = half(1);
            if (glm::dot(mesh.facet_normal(first), mesh.facet_normal(second)) < std::cos(glm::radians(degrees))) {
                folded.push_back(second);
                facet = first;
            }
        }
    }
    mesh.facets.insert(mesh.facets.end(), folded.begin(), folded.end());
}

void pair_triangles(PolyMesh& mesh, double degrees)
{
    struct Pair
    {
        double flatness;  ///< cosine between the normals
        std::size_t first, second;
        std::array<int, 4> quad;
    };
    std::map<std::pair<int, int>, std::size_t> owner;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const auto& p = mesh.facets[f].points;
        if (p.size() != 3) continue;
        for (std::size_t k = 0; k < 3; ++k) owner[{p[k], p[(k + 1) % 3]}] = f;
    }
    const auto apex = [&](std::size_t f, int a, int b) {
        const auto& p = mesh.facets[f].points;
        return *std::find_if(p.begin(), p.end(), [&](int q) { return q != a && q != b; });
    };
    std::vector<Pair> pairs;
    for (const auto& [edge, f] : owner) {
        const auto [a, b] = edge;
        const auto other = owner.find({b, a});
        if (a > b || other == owner.end()) continue;
        const std::size_t g = other->second;
        if (mesh.facets[f].material != mesh.facets[g].material) continue;
        // Counter-clockwise: a, then the other triangle's apex, b, this triangle's apex.
        const Pair pair{glm::dot(mesh.facet_normal(mesh.facets[f]), mesh.facet_normal(mesh.facets[g])),
                        f,
                        g,
                        {a, apex(g, b, a), b, apex(f, a, b)}};
        std::vector<glm::dvec3> loop;
        for (const int p : pair.quad) loop.push_back(mesh.points[std::size_t(p)]);
        const glm::dvec3 up = newell(loop);
        bool convex = true;
        for (std::size_t k = 0; k < 4; ++k)
            convex = convex &&
                     glm::dot(glm::cross(loop[(k + 1) % 4] - loop[k], loop[(k + 2) % 4] - loop[(k + 1) % 4]), up) > 0;
        if (convex && pair.flatness >= std::cos(glm::radians(degrees))) pairs.push_back(pair);
    }
    std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) { return p.flatness > q.flatness; });
    std::vector<bool> gone(mesh.facets.size(), false), taken(mesh.facets.size(), false);
    for (const Pair& pair : pairs) {
        if (taken[pair.first] || taken[pair.second]) continue;
        taken[pair.first] = taken[pair.second] = gone[pair.second] = true;
        mesh.facets[pair.first].points.assign(pair.quad.begin(), pair.quad.end());
        mesh.facets[pair.first].uvs.clear();
    }
    std::vector<Facet> left;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f)
        if (!gone[f]) left.push_back(std::move(mesh.facets[f]));
    mesh.facets = std::move(left);
}

std::vector<int> mirror_x(PolyMesh& mesh)
{
    const std::size_t points = mesh.points.size(), facets = mesh.facets.size();
    std::vector<int> image(points);
    for (std::size_t p = 0; p < points; ++p) {
        const glm::dvec3 at = mesh.points[p];
        image[p] = at.x == 0.0 ? int(p) : mesh.add_point({-at.x, at.y, at.z});
    }
    for (std::size_t f = 0; f < facets; ++f) {
        Facet facet = mesh.facets[f];
        for (int& p : facet.points) p = image[std::size_t(p)];
        std::reverse(facet.points.begin(), facet.points.end());
        std::reverse(facet.uvs.begin(), facet.uvs.end());
        mesh.facets.push_back(std::move(facet));
    }
    return image;
}

}  // namespace kerf::maker
