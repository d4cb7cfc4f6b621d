#include "common/repair/clean_soup.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "common/mesh/is_finite.h"
#include "common/mesh/tolerances.h"

namespace kerf::core {

namespace {

glm::vec3 unit_or_none(const glm::vec3& n)
{
    if (!is_finite(n)) return kNoNormal;
    const glm::dvec3 wide(n);
    // The square is as far from 1 as the length twice over: most normals need no root.
    if (std::abs(glm::dot(wide, wide) - 1.0) <= kUnitTolerance) return n;
    const double length = std::hypot(wide.x, wide.y, wide.z);
    if (!(length > 0.0)) return kNoNormal;
    return std::abs(length - 1.0) > kUnitTolerance ? glm::vec3(wide / length) : n;
}

glm::dvec3 area_vector(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const glm::dvec3 e = glm::dvec3(b) - glm::dvec3(a), f = glm::dvec3(c) - glm::dvec3(a);
    return {e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x};
}

void fill_missing_normals(TriangleSoup& soup)
{
    std::vector<glm::dvec3> sum(soup.vertices.size(), glm::dvec3(0.0));
    for (const Triangle& t : soup.triangles) {
        const glm::dvec3 n =
            area_vector(soup.vertices[t[0]].position, soup.vertices[t[1]].position, soup.vertices[t[2]].position);
        for (const std::uint32_t corner : t) sum[corner] += n;
    }
    for (std::size_t i = 0; i < soup.vertices.size(); ++i) {
        Vertex& v = soup.vertices[i];
        if (v.normal != kNoNormal) continue;
        const double length = std::hypot(sum[i].x, sum[i].y, sum[i].z);
        v.normal = length > 0.0 ? glm::vec3(sum[i] / length) : glm::vec3(0.0f, 0.0f, 1.0f);
    }
}

}  // namespace

UnfitAttributes clean(TriangleSoup& soup)
{
    UnfitAttributes unfit;
    std::uint64_t missing = 0;
    for (Vertex& v : soup.vertices) {
        v.position += 0.0f;
        const bool unfit_normal = soup.has_normals && !is_finite(v.normal);
        const bool unfit_uv = !std::isfinite(v.uv.x) || !std::isfinite(v.uv.y);
        if (soup.has_normals) {
            v.normal = unit_or_none(v.normal);
            missing += v.normal == kNoNormal;
        }
        if (unfit_uv) v.uv = {};
        unfit.normals += unfit_normal;
        unfit.uvs += unfit_uv;
        unfit.vertices += unfit_normal || unfit_uv;
    }
    if (!soup.has_normals) return unfit;
    soup.has_normals = missing < soup.vertices.size();
    if (soup.has_normals && missing > 0) fill_missing_normals(soup);
    return unfit;
}

std::uint64_t clean_streams(TriangleSoup& soup)
{
    std::uint64_t count = 0;
    for (VertexStream& stream : soup.streams)
        for (float& value : stream.values)
            if (!std::isfinite(value)) {
                value = 0.0f;
                ++count;
            }
    return count;
}

}  // namespace kerf::core
