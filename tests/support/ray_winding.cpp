#include "support/ray_winding.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

namespace kerf::core::test {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Which way the triangle (a, b, c) turns, seen against the ray: 1, -1 or 0.
int turn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    const auto planar = [](const glm::dvec3& p) { return Kernel::Point_2(p.x, p.y); };
    return static_cast<int>(CGAL::orientation(planar(a), planar(b), planar(c)));
}

/// On which side of the plane of (a, b, c) a point lies: 1 where the normal points to.
int side(const std::array<glm::dvec3, 3>& triangle, const glm::dvec3& point)
{
    const auto spatial = [](const glm::dvec3& p) { return Kernel::Point_3(p.x, p.y, p.z); };
    return static_cast<int>(
        CGAL::orientation(spatial(triangle[0]), spatial(triangle[1]), spatial(triangle[2]), spatial(point)));
}

}  // namespace

RayWinding::RayWinding(const std::vector<IndexedMesh>& surfaces)
{
    glm::dvec2 lo(std::numeric_limits<double>::infinity()), hi = -lo;
    for (const IndexedMesh& mesh : surfaces)
        for (const Triangle& t : mesh.triangles) {
            auto& triangle = triangles_.emplace_back();
            for (std::size_t i = 0; i < 3; ++i) {
                triangle[i] = glm::dvec3(mesh.vertices[t[i]].position);
                lo = glm::min(lo, glm::dvec2(triangle[i]));
                hi = glm::max(hi, glm::dvec2(triangle[i]));
            }
        }
    cells_ = std::size_t(std::sqrt(double(triangles_.size()))) + 1;
    lo_ = lo;
    for (int axis = 0; axis < 2; ++axis)
        cells_per_unit_[axis] = hi[axis] > lo[axis] ? double(cells_) / (hi[axis] - lo[axis]) : 0.0;

    first_.assign(cells_ * cells_ + 1, 0);
    for (const auto& triangle : triangles_) for_each_cell(triangle, [&](std::size_t c) { ++first_[c + 1]; });
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    in_cell_.resize(first_.back());
    std::vector<std::uint32_t> fill(first_.begin(), first_.end() - 1);
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for_each_cell(triangles_[t], [&](std::size_t c) { in_cell_[fill[c]++] = t; });
}

std::optional<int> RayWinding::around(const glm::dvec3& point) const
{
    int winding = 0;
    const std::size_t at = cell(point.y, 1) * cells_ + cell(point.x, 0);
    for (std::uint32_t i = first_[at]; i < first_[at + 1]; ++i) {
        const auto& triangle = triangles_[in_cell_[i]];
        const auto& [a, b, c] = triangle;
        if (a.z < point.z && b.z < point.z && c.z < point.z) continue;
        const int ab = turn(a, b, point), bc = turn(b, c, point), ca = turn(c, a, point);
        const auto [least, most] = std::minmax({ab, bc, ca});
        // Beside it, as is every point that a triangle along the ray has no edge over.
        if (least < 0 && most > 0) continue;
        // A needle along the ray.
        if (least == 0 && most == 0) continue;
        if (least == 0 || most == 0) return std::nullopt;
        // All three are one number: 1 where the triangle faces along the ray, -1 where it faces the other way.
        const int facing = least, where = side(triangle, point);
        if (where == 0) return std::nullopt;
        if (where != facing) winding += facing;
    }
    return winding;
}

std::size_t RayWinding::cell(double coordinate, int axis) const
{
    const double number = (coordinate - lo_[axis]) * cells_per_unit_[axis];
    return std::size_t(std::clamp(number, 0.0, double(cells_ - 1)));
}

template <class Visit>
void RayWinding::for_each_cell(const std::array<glm::dvec3, 3>& triangle, Visit visit) const
{
    const auto& [a, b, c] = triangle;
    const auto [x0, x1] = std::minmax({a.x, b.x, c.x});
    const auto [y0, y1] = std::minmax({a.y, b.y, c.y});
    for (std::size_t y = cell(y0, 1); y <= cell(y1, 1); ++y)
        for (std::size_t x = cell(x0, 0); x <= cell(x1, 0); ++x) visit(y * cells_ + x);
}

}  // namespace kerf::core::test
