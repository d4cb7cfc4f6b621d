#include "maker/panels.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <map>
#include <set>
#include <stdexcept>

#include "maker/triangulate.h"

namespace kerf::maker {
namespace {

/// The outline of a region of facets, counter-clockwise seen from outside.
std::vector<int> outline(const PolyMesh& mesh, const std::vector<std::size_t>& region)
{
    std::set<std::pair<int, int>> edges;
    for (const std::size_t f : region) {
        const auto& loop = mesh.facets[f].points;
        for (std::size_t i = 0; i < loop.size(); ++i) edges.insert({loop[i], loop[(i + 1) % loop.size()]});
    }
    std::map<int, int> next;
    for (const auto& [a, b] : edges)
        if (!edges.contains({b, a}) && !next.try_emplace(a, b).second)
            throw std::logic_error("inset: the region's outline meets itself");
    std::vector<int> loop{next.begin()->first};
    for (int at = next.at(loop[0]); at != loop[0]; at = next.at(at)) loop.push_back(at);
    if (loop.size() != next.size()) throw std::logic_error("inset: the region has a hole");
    return loop;
}

}  // namespace

void inset(PolyMesh& mesh, const std::vector<std::size_t>& region, double margin, double depth,
           std::string_view material)
{
    const std::vector<int> loop = outline(mesh, region);
    const std::size_t n = loop.size();
    const auto position = [&](int p) { return mesh.points[std::size_t(p)]; };

    // The normal at a point is the mean of the region's facets there.
    std::map<int, glm::dvec3> normals;
    for (const std::size_t f : region)
        for (const int p : mesh.facets[f].points)
            normals.try_emplace(p, glm::dvec3{0.0}).first->second += mesh.facet_normal(mesh.facets[f]);
    for (auto& [p, normal] : normals) normal = glm::normalize(normal);

    std::map<int, int> moved;
    std::vector<int> frame(n), sunk(n);
    for (std::size_t i = 0; i < n; ++i) {
        const int before = loop[(i + n - 1) % n], at = loop[i], after = loop[(i + 1) % n];
        const glm::dvec3 normal = normals.at(at);
        // Both edges move inwards by the margin: the corner moves along their mitre.
        const glm::dvec3 in_before = glm::normalize(glm::cross(normal, position(at) - position(before)));
        const glm::dvec3 in_after = glm::normalize(glm::cross(normal, position(after) - position(at)));
        const glm::dvec3 mitre = (in_before + in_after) / (1.0 + glm::dot(in_before, in_after));
        frame[i] = margin == 0 ? at : mesh.add_point(position(at) + mitre * margin);
        sunk[i] = mesh.add_point(position(frame[i]) - normal * depth);
        moved[at] = sunk[i];
    }
    const std::string_view old = mesh.facets[region[0]].material;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = (i + 1) % n;
        if (margin != 0) mesh.add_facet({loop[i], loop[j], frame[j], frame[i]}, old);
        mesh.add_facet({frame[i], frame[j], sunk[j], sunk[i]}, material);
    }
    for (const auto& [p, normal] : normals)
        if (!moved.contains(p)) mesh.points[std::size_t(p)] -= normal * depth;
    for (const std::size_t f : region) {
        mesh.facets[f].material = material;
        for (int& p : mesh.facets[f].points)
            if (const auto to = moved.find(p); to != moved.end()) p = to->second;
    }
}

void boss(PolyMesh& mesh, std::size_t facet, const std::array<double, 4>& s0_s1_t0_t1,
          const std::vector<BossLayer>& layers, std::string_view material)
{
    const Facet base = mesh.facets[facet];
    const glm::dvec3 normal = mesh.facet_normal(base);
    const auto at = [&](double s, double t) {
        const auto p = [&](std::size_t corner) { return mesh.points[std::size_t(base.points[corner])]; };
        return glm::mix(glm::mix(p(0), p(1), t), glm::mix(p(3), p(2), t), s);
    };
    const auto [s0, s1, t0, t1] = s0_s1_t0_t1;
    const std::array<glm::dvec3, 4> foot{at(s0, t0), at(s0, t1), at(s1, t1), at(s1, t0)};
    const glm::dvec3 middle = (foot[0] + foot[1] + foot[2] + foot[3]) * 0.25;
    std::vector<int> below;
    for (const glm::dvec3& p : foot) below.push_back(mesh.add_point(p));
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t j = (i + 1) % 4;
        mesh.add_facet({base.points[i], base.points[j], below[j], below[i]}, base.material);
    }
    mesh.facets[facet] = mesh.facets.back();  // numbers of other facets stay
    mesh.facets.pop_back();
    for (const BossLayer& layer : layers) {
        std::vector<int> above;
        for (const glm::dvec3& p : foot)
            above.push_back(mesh.add_point(middle + (p - middle) * layer.scale + normal * layer.height));
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t j = (i + 1) % 4;
            mesh.add_facet({below[i], below[j], above[j], above[i]}, material);
        }
        below = above;
    }
    mesh.add_facet(below, material);
}

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

void mirror_x(PolyMesh& mesh)
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
}

}  // namespace kerf::maker
