#include "maker/delaunay.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <map>
#include <stdexcept>

#include "maker/triangulate.h"

namespace kerf::maker {
namespace {

using Triangle = std::array<int, 3>;

double area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Positive when d lies inside the circle through a, b, c (counter-clockwise).
double in_circle(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c, const glm::dvec2& d)
{
    const glm::dvec2 p = a - d, q = b - d, r = c - d;
    return glm::dot(p, p) * (q.x * r.y - q.y * r.x) - glm::dot(q, q) * (p.x * r.y - p.y * r.x) +
           glm::dot(r, r) * (p.x * q.y - p.y * q.x);
}

/// Flips until every edge is Delaunay. Each flip lowers the surface that the triangulation makes of the paraboloid, so
/// it ends; `kNoise` keeps four points on a circle from flipping for ever.
void flip(std::vector<Triangle>& triangles, const std::vector<glm::dvec2>& points)
{
    constexpr double kNoise = 1e-12;
    const auto at = [&](int p) { return points[std::size_t(p)]; };
    for (bool changed = true; changed;) {
        changed = false;
        std::map<std::pair<int, int>, std::size_t> owner;
        for (std::size_t t = 0; t < triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) owner[{triangles[t][k], triangles[t][(k + 1) % 3]}] = t;
        for (const auto& [edge, t] : owner) {
            const auto opposite = owner.find({edge.second, edge.first});
            if (opposite == owner.end()) continue;
            const int a = edge.first, b = edge.second;
            const auto apex = [&](std::size_t triangle) {
                for (const int p : triangles[triangle])
                    if (p != a && p != b) return p;
                return -1;
            };
            const int c = apex(t), d = apex(opposite->second);
            if (in_circle(at(a), at(b), at(c), at(d)) <= kNoise) continue;
            if (area(at(c), at(a), at(d)) <= 0 || area(at(c), at(d), at(b)) <= 0) continue;
            triangles[t] = {c, a, d};
            triangles[opposite->second] = {c, d, b};
            changed = true;
            break;  // the table of owners is stale
        }
    }
}

}  // namespace

std::vector<Triangle> delaunay(const std::vector<glm::dvec2>& polygon, const std::vector<glm::dvec2>& inside)
{
    std::vector<glm::dvec2> points = polygon;
    std::vector<glm::dvec3> lifted;
    for (const glm::dvec2& p : polygon) lifted.push_back({p.x, p.y, 0.0});
    std::vector<Triangle> triangles = triangulate(lifted);
    for (const glm::dvec2& p : inside) {
        const int number = int(points.size());
        points.push_back(p);
        const auto around = std::find_if(triangles.begin(), triangles.end(), [&](const Triangle& t) {
            for (std::size_t k = 0; k < 3; ++k)
                if (area(points[std::size_t(t[k])], points[std::size_t(t[(k + 1) % 3])], p) <= 0) return false;
            return true;
        });
        if (around == triangles.end()) throw std::logic_error("delaunay: a point lies outside or on an edge");
        const auto [a, b, c] = *around;
        *around = {a, b, number};
        triangles.push_back({b, c, number});
        triangles.push_back({c, a, number});
        flip(triangles, points);
    }
    return triangles;
}

}  // namespace kerf::maker
