#include "maker/corners.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

namespace kerf::maker {
namespace {

constexpr double kStep = 1e-5;

}  // namespace

double rounded(double x)
{
    const double r = std::round(x / kStep) * kStep;
    return r == 0.0 ? 0.0 : r;
}

PolyMesh with_rounded_points(PolyMesh mesh)
{
    for (glm::dvec3& p : mesh.points) p = {rounded(p.x), rounded(p.y), rounded(p.z)};
    return mesh;
}

glm::dvec2 box_uv(const glm::dvec3& p, const glm::dvec3& normal)
{
    const glm::dvec3 a = glm::abs(normal);
    if (a.y >= a.x && a.y >= a.z) return {p.x, normal.y > 0 ? -p.z : p.z};
    if (a.x >= a.z) return {normal.x > 0 ? -p.z : p.z, p.y};
    return {normal.z > 0 ? p.x : -p.x, p.y};
}

std::vector<std::vector<glm::dvec3>> corner_normals(const PolyMesh& mesh)
{
    std::map<std::pair<int, int>, glm::dvec3> sums;  // by point and group
    std::vector<glm::dvec3> areas;
    for (const Facet& facet : mesh.facets) {
        std::vector<glm::dvec3> loop;
        for (const int p : facet.points) loop.push_back(mesh.points[std::size_t(p)]);
        areas.push_back(newell(loop));
        if (facet.smoothing == 0) continue;
        for (const int p : facet.points) {
            const auto at = sums.try_emplace({p, facet.smoothing}, glm::dvec3{0.0}).first;
            at->second += areas.back();
        }
    }
    std::vector<std::vector<glm::dvec3>> normals;
    for (std::size_t f = 0; f < mesh.facets.size(); ++f) {
        const Facet& facet = mesh.facets[f];
        std::vector<glm::dvec3>& of_facet = normals.emplace_back();
        for (const int p : facet.points)
            of_facet.push_back(glm::normalize(facet.smoothing == 0 ? areas[f] : sums.at({p, facet.smoothing})));
    }
    return normals;
}

}  // namespace kerf::maker
