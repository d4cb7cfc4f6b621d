#include "maker/panels.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <set>
#include <stdexcept>

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

}  // namespace kerf::maker
