#include "common/fracture/inside_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/mesh/box.h"
#include "common/mesh/position_order.h"

namespace kerf::core {

namespace {

/// Where a line meets a triangle.
struct Hit
{
    double height = 0.0;  ///< along the line
    int turns = 0;        ///< 1 where the line leaves the solid, -1 where it enters
};

/// Parallel lines, in a grid of cells that hold about one each.
class Lines
{
public:
    Lines(const Box& box, int axis, std::size_t count, Random& random)
        : u_((axis + 1) % 3), v_((axis + 2) % 3), w_(axis), lo_(box.lo), size_(glm::dvec3(box.hi) - glm::dvec3(box.lo))
    {
        side_ = static_cast<std::size_t>(std::sqrt(double(count))) + 1;
        cells_.resize(side_ * side_);
        for (std::size_t i = 0; i < count; ++i) {
            const double u = lo_[u_] + size_[u_] * random.unit(), v = lo_[v_] + size_[v_] * random.unit();
            cells_[column(v, v_) * side_ + column(u, u_)].push_back(static_cast<std::uint32_t>(places_.size()));
            places_.push_back({u, v});
        }
        hits_.resize(count);
    }

    /// Whether a line passes through a box.
    bool any_meets(const Box& box) const
    {
        const double least_u = box.lo[u_], most_u = box.hi[u_], least_v = box.lo[v_], most_v = box.hi[v_];
        for (std::size_t row = column(least_v, v_); row <= column(most_v, v_); ++row)
            for (std::size_t place = column(least_u, u_); place <= column(most_u, u_); ++place)
                for (const std::uint32_t line : cells_[row * side_ + place]) {
                    const auto [u, v] = places_[line];
                    if (least_u <= u && u <= most_u && least_v <= v && v <= most_v) return true;
                }
        return false;
    }

    void meet(std::array<glm::vec3, 3> corners)
    {
        // In one order, so that the triangle's first corner does not matter.
        int turns = 1;
        const auto in_order = [&](std::size_t i, std::size_t j) {
            if (!lexicographically_less(corners[j], corners[i])) return;
            std::swap(corners[i], corners[j]);
            turns = -turns;
        };
        in_order(0, 1);
        in_order(1, 2);
        in_order(0, 1);
        const glm::dvec3 a(corners[0]), b(corners[1]), c(corners[2]);
        const double area = (b[u_] - a[u_]) * (c[v_] - a[v_]) - (b[v_] - a[v_]) * (c[u_] - a[u_]);
        if (area == 0.0) return;
        const auto [least_u, most_u] = std::minmax({a[u_], b[u_], c[u_]});
        const auto [least_v, most_v] = std::minmax({a[v_], b[v_], c[v_]});
        for (std::size_t row = column(least_v, v_); row <= column(most_v, v_); ++row)
            for (std::size_t place = column(least_u, u_); place <= column(most_u, u_); ++place)
                for (const std::uint32_t line : cells_[row * side_ + place]) {
                    const auto [u, v] = places_[line];
                    // Exactly, as boxes are asked: so it does not matter which triangles are not looked at.
                    if (u < least_u || u > most_u || v < least_v || v > most_v) continue;
                    // Shares of the corners.
                    const double of_b = ((u - a[u_]) * (c[v_] - a[v_]) - (v - a[v_]) * (c[u_] - a[u_])) / area;
                    const double of_c = ((b[u_] - a[u_]) * (v - a[v_]) - (b[v_] - a[v_]) * (u - a[u_])) / area;
                    if (of_b < 0.0 || of_c < 0.0 || of_b + of_c >= 1.0) continue;
                    hits_[line].push_back(
                        {a[w_] + of_b * (b[w_] - a[w_]) + of_c * (c[w_] - a[w_]), area > 0.0 ? turns : -turns});
                }
    }

    /// Calls visit(from, length) for each part of a line that lies inside.
    template <class Visit>
    void for_each_run(Visit visit)
    {
        for (std::size_t line = 0; line < hits_.size(); ++line) {
            std::vector<Hit>& hits = hits_[line];
            std::ranges::sort(hits, [](const Hit& a, const Hit& b) {
                return a.height != b.height ? a.height < b.height : a.turns < b.turns;
            });
            int winding = 0;
            for (std::size_t i = 0; i + 1 < hits.size(); ++i) {
                winding -= hits[i].turns;
                const double length = hits[i + 1].height - hits[i].height;
                if (winding <= 0 || !(length > 0.0)) continue;
                glm::dvec3 from;
                from[u_] = places_[line][0];
                from[v_] = places_[line][1];
                from[w_] = hits[i].height;
                visit(from, length);
            }
        }
    }

private:
    std::size_t column(double coordinate, int axis) const
    {
        const double share = size_[axis] > 0.0 ? (coordinate - lo_[axis]) / size_[axis] : 0.0;
        return std::min(static_cast<std::size_t>(std::max(share, 0.0) * double(side_)), side_ - 1);
    }

    int u_, v_, w_;
    glm::dvec3 lo_, size_;
    std::size_t side_ = 1;
    std::vector<std::array<double, 2>> places_;
    std::vector<std::vector<std::uint32_t>> cells_;
    std::vector<std::vector<Hit>> hits_;
};

}  // namespace

InsideSample::InsideSample(const TriangleSearch& triangles, std::size_t lines, Random& random)
{
    // Of a solid that fills little of its box few lines meet any: then more are sent.
    constexpr std::size_t kMore = 8, kMostLines = std::size_t{1} << 20;

    const Box box = triangles.bounds();
    const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    axis_ = size.x <= size.y && size.x <= size.z ? 0 : size.y <= size.z ? 1 : 2;
    const std::size_t first = std::min(lines, kMostLines);
    for (std::size_t count = first; runs_.size() < first / 4 + 1 && count <= kMostLines; count *= kMore) {
        Lines sent(box, axis_, count, random);
        triangles.find([&](const Box& part) { return sent.any_meets(part); },
                       [&](std::span<const TriangleSearch::Corners> found) {
                           for (const TriangleSearch::Corners& corners : found) sent.meet(corners);
                       });
        runs_.clear();
        double sum = 0.0;
        sent.for_each_run([&](const glm::dvec3& from, double length) {
            sum += length;
            runs_.push_back({from, length, sum});
        });
    }
}

glm::dvec3 InsideSample::point(Random& random) const
{
    const double place = random.unit() * runs_.back().sum;
    const auto run = std::ranges::upper_bound(runs_, place, {}, &Run::sum);
    const Run& found = run == runs_.end() ? runs_.back() : *run;
    glm::dvec3 point = found.from;
    point[axis_] += random.unit() * found.length;
    return point;
}

}  // namespace kerf::core
