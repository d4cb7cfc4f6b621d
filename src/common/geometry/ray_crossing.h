#pragma once

#include <glm/vec3.hpp>

#include "common/geometry/turn.h"

namespace kerf::core {

/// An axis-parallel ray from a vertex.
struct AxisRay
{
    glm::vec3 origin;
    int axis = 0;           ///< 0, 1, 2 for x, y, z
    bool ascending = true;  ///< towards larger coordinates
};

/// A point of a plane.
struct PlanarPoint
{
    float u = 0.0f, v = 0.0f;
};

/// The term of the edge from p to q in the winding number around o: whether it crosses the ray from o towards larger u,
/// +1 upwards, -1 downwards, 0 not at all. An end that is on the ray counts as below it (half-open rule). Exact.
inline int edge_crossing(const PlanarPoint& o, const PlanarPoint& p, const PlanarPoint& q)
{
    const bool upwards = p.v <= o.v;
    if (upwards == (q.v <= o.v)) return 0;
    const double side = turn({p.u, p.v}, {q.u, q.v}, {o.u, o.v});
    return upwards ? (side > 0.0 ? 1 : 0) : (side < 0.0 ? -1 : 0);
}

/// The term of one triangle in a signed crossing count: +1 if the ray leaves through the triangle, from behind it to
/// its front, -1 if it enters, 0 if it misses. Edges and vertices are counted once between the triangles that share
/// them (half-open rule, edges evaluated in a canonical order), so a closed surface gives its winding number.
inline int ray_crossing(const AxisRay& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    const int w = ray.axis, u = (w + 1) % 3, v = (w + 2) % 3;
    const glm::vec3& o = ray.origin;
    if ((a[v] <= o[v]) == (b[v] <= o[v]) && (b[v] <= o[v]) == (c[v] <= o[v])) return 0;
    // Wholly behind the origin, seen along the ray.
    if (ray.ascending ? a[w] < o[w] && b[w] < o[w] && c[w] < o[w] : a[w] > o[w] && b[w] > o[w] && c[w] > o[w]) return 0;

    const PlanarPoint origin{o[u], o[v]}, p{a[u], a[v]}, q{b[u], b[v]}, r{c[u], c[v]};
    const int turns = edge_crossing(origin, p, q) + edge_crossing(origin, q, r) + edge_crossing(origin, r, p);
    if (turns == 0) return 0;

    // The sign of the normal along the axis is that of `turns`; the distance to the plane along the axis has the sign
    // of dot(normal, a - o) / normal[axis].
    const glm::dvec3 e = glm::dvec3(b) - glm::dvec3(a), f = glm::dvec3(c) - glm::dvec3(a),
                     g = glm::dvec3(a) - glm::dvec3(o);
    const double towards =
        (e.y * f.z - e.z * f.y) * g.x + (e.z * f.x - e.x * f.z) * g.y + (e.x * f.y - e.y * f.x) * g.z;
    const bool ascends = (turns > 0) == (towards > 0.0);
    if (ascends != ray.ascending) return 0;
    return ray.ascending ? turns : -turns;
}

}  // namespace kerf::core
