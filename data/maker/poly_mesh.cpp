#include "maker/poly_mesh.h"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <stdexcept>

namespace kerf::maker {

int PolyMesh::add_point(const glm::dvec3& p)
{
    points.push_back(p);
    return int(points.size()) - 1;
}

void PolyMesh::add_facet(std::vector<int> loop, std::string_view material, std::vector<glm::dvec2> uvs, int smoothing)
{
    for (std::size_t i = 0; i < loop.size();) {
        if (loop.size() > 1 && loop[i] == loop[(i + 1) % loop.size()]) {
            loop.erase(loop.begin() + std::ptrdiff_t(i));
            if (!uvs.empty()) uvs.erase(uvs.begin() + std::ptrdiff_t(i));
        } else {
            ++i;
        }
    }
    if (loop.size() < 3) return;
    facets.push_back({std::move(loop), std::move(uvs), material, smoothing});
}

int PolyMesh::split_edge(int a, int b)
{
    const int middle = add_point((points[std::size_t(a)] + points[std::size_t(b)]) * 0.5);
    int found = 0;
    for (Facet& facet : facets) {
        const std::size_t n = facet.points.size();
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = (i + 1) % n;
            const int from = facet.points[i], to = facet.points[j];
            if ((from != a || to != b) && (from != b || to != a)) continue;
            if (!facet.uvs.empty()) {
                const glm::dvec2 uv = (facet.uvs[i] + facet.uvs[j]) * 0.5;
                facet.uvs.insert(facet.uvs.begin() + std::ptrdiff_t(i) + 1, uv);
            }
            facet.points.insert(facet.points.begin() + std::ptrdiff_t(i) + 1, middle);
            ++found;
            break;
        }
    }
    if (found != 2) throw std::logic_error("split_edge: the edge does not lie between two facets");
    return middle;
}

glm::dvec3 newell(const std::vector<glm::dvec3>& loop)
{
    glm::dvec3 area{0.0};
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const glm::dvec3& a = loop[i];
        const glm::dvec3& b = loop[(i + 1) % loop.size()];
        area += glm::dvec3{(a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x), (a.x - b.x) * (a.y + b.y)} * 0.5;
    }
    return area;
}

glm::dvec3 PolyMesh::facet_normal(const Facet& facet) const
{
    std::vector<glm::dvec3> loop;
    for (const int p : facet.points) loop.push_back(points[std::size_t(p)]);
    return glm::normalize(newell(loop));
}

void PolyMesh::transform(double scale, const glm::dvec3& offset)
{
    for (glm::dvec3& p : points) p = p * scale + offset;
}

void PolyMesh::fit(double size)
{
    glm::dvec3 lo{std::numeric_limits<double>::max()}, hi{-std::numeric_limits<double>::max()};
    for (const glm::dvec3& p : points) {
        lo = glm::min(lo, p);
        hi = glm::max(hi, p);
    }
    const glm::dvec3 extent = hi - lo;
    const double scale = size / std::max({extent.x, extent.y, extent.z});
    transform(scale, (lo + hi) * (-0.5 * scale));
}

}  // namespace kerf::maker
