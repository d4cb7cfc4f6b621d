#pragma once

#include "baseline/slice.h"
#include "common/mesh/plane_noise.h"
#include "common/mesh/triangle_soup.h"
#include "linear/fragment.h"
#include "support/fixtures.h"

// What the tests of the baseline's inside share.

namespace kerf::core::baseline {

inline Fragment fragment_of(IndexedMesh mesh)
{
    Fragment fragment;
    fragment.mesh = std::move(mesh);
    fragment.bounds = fragment.mesh.bounds();
    fragment.noise = plane_noise(fragment.bounds.largest_coordinate());
    return fragment;
}

inline const VertexLookup kAllLookups[] = {VertexLookup::scan, VertexLookup::two_bucket_hash, VertexLookup::hash,
                                           VertexLookup::remap};

/// The prism over a polygon, given counter-clockwise, from z = -1 to z = 1. `ears` triangulate the polygon.
inline TriangleSoup prism(const std::vector<glm::vec2>& polygon, const std::vector<Triangle>& ears)
{
    TriangleSoup soup;
    const auto n = static_cast<std::uint32_t>(polygon.size());
    for (const float z : {-1.0f, 1.0f})
        for (const glm::vec2& p : polygon) soup.vertices.push_back({{p.x, p.y, z}, {}, {}});
    for (const auto& [a, b, c] : ears) {
        soup.triangles.push_back({a, c, b});
        soup.triangles.push_back({n + a, n + b, n + c});
    }
    for (std::uint32_t i = 0; i < n; ++i) {
        const std::uint32_t j = (i + 1) % n;
        soup.triangles.push_back({i, j, n + j});
        soup.triangles.push_back({i, n + j, n + i});
    }
    soup.has_normals = false;
    return soup;
}

inline TriangleSoup joined(TriangleSoup a, const TriangleSoup& b)
{
    const auto offset = static_cast<std::uint32_t>(a.vertices.size());
    a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
    for (const Triangle& t : b.triangles) a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
    return a;
}

/// A spike so thin that the plane z = 0 cuts its three long edges in one and the same float point, (1, 1, 0).
inline TriangleSoup spike()
{
    TriangleSoup soup;
    const float next = 1.0f + 0x1p-23f;
    for (const glm::vec3& p : {glm::vec3(1, 1, -1), glm::vec3(next, 1, -1), glm::vec3(1, next, -1), glm::vec3(1, 1, 1)})
        soup.vertices.push_back({p, {}, {}});
    soup.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
    soup.has_normals = false;
    return soup;
}

}  // namespace kerf::core::baseline
