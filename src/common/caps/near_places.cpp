#include "common/caps/near_places.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace kerf::core {

std::vector<Index> stand_ins(std::span<const glm::dvec2> places, std::span<const Index> order, double radius)
{
    // Cells are as large as the radius, so near places lie in one of nine.
    const auto cell = [&](const glm::dvec2& p, int right, int up) {
        const auto x = static_cast<std::int64_t>(std::floor(p.x / radius)) + right;
        const auto y = static_cast<std::int64_t>(std::floor(p.y / radius)) + up;
        return static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15u ^ static_cast<std::uint64_t>(y);
    };
    std::unordered_map<std::uint64_t, std::vector<Index>> in_cell;
    const auto near = [&](const glm::dvec2& p) {
        for (int right = -1; right <= 1; ++right)
            for (int up = -1; up <= 1; ++up) {
                const auto entry = in_cell.find(cell(p, right, up));
                if (entry == in_cell.end()) continue;
                for (const Index other : entry->second) {
                    const glm::dvec2 apart = glm::abs(places[other] - p);
                    if (apart.x <= radius && apart.y <= radius) return other;
                }
            }
        return kNone;
    };
    std::vector<Index> result(places.size());
    for (const Index i : order) {
        const Index other = near(places[i]);
        result[i] = other == kNone ? i : other;
        if (other == kNone) in_cell[cell(places[i], 0, 0)].push_back(i);
    }
    return result;
}

void PlaceTree::build(std::span<const glm::dvec2> places, std::vector<Index> which)
{
    places_ = places;
    which_ = std::move(which);
    halve(0, which_.size(), 0);
}

void PlaceTree::halve(std::size_t first, std::size_t last, int axis)
{
    if (last - first < 2) return;
    const std::size_t middle = first + (last - first) / 2;
    const auto at = [&](std::size_t i) { return which_.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(at(first), at(middle), at(last),
                     [&](Index a, Index b) { return places_[a][axis] < places_[b][axis]; });
    halve(first, middle, 1 - axis);
    halve(middle + 1, last, 1 - axis);
}

void PlaceTree::append_beside(const glm::dvec2& a, const glm::dvec2& b, double radius, std::vector<Index>& found,
                              std::uint64_t& looks) const
{
    const double length = glm::distance(a, b);
    if (!(length > 0.0)) return;
    const std::size_t before = found.size();
    constexpr double kFar = std::numeric_limits<double>::infinity();
    search({a, (b - a) / length, length, radius}, 0, which_.size(), 0, found, looks, glm::dvec2(-kFar),
           glm::dvec2(kFar));
    const auto along = [&](Index i) { return glm::dot(places_[i] - a, b - a); };
    std::sort(found.begin() + static_cast<std::ptrdiff_t>(before), found.end(), [&](Index i, Index j) {
        const double p = along(i), q = along(j);
        return p != q ? p < q : i < j;
    });
}

void PlaceTree::search(const Edge& edge, std::size_t first, std::size_t last, int axis, std::vector<Index>& found,
                       std::uint64_t& looks, glm::dvec2 lo, glm::dvec2 hi) const
{
    if (first == last) return;
    // The part of the edge that is within the radius of the box.
    double begin = 0.0, end = edge.length;
    for (int i = 0; i < 2; ++i) {
        const double below = lo[i] - edge.radius - edge.from[i], above = hi[i] + edge.radius - edge.from[i];
        if (edge.direction[i] == 0.0) {
            if (below > 0.0 || above < 0.0) return;
            continue;
        }
        const double p = below / edge.direction[i], q = above / edge.direction[i];
        begin = std::max(begin, std::min(p, q));
        end = std::min(end, std::max(p, q));
    }
    if (begin > end) return;
    const std::size_t middle = first + (last - first) / 2;
    const Index place = which_[middle];
    const glm::dvec2& p = places_[place];
    ++looks;
    const glm::dvec2 offset = p - edge.from;
    const double along = glm::dot(offset, edge.direction);
    const double beside = std::abs(offset.x * edge.direction.y - offset.y * edge.direction.x);
    if (along > 0.0 && along < edge.length && beside <= edge.radius) found.push_back(place);
    const double split = p[axis];
    glm::dvec2 lower = hi, upper = lo;
    lower[axis] = upper[axis] = split;
    search(edge, first, middle, 1 - axis, found, looks, lo, lower);
    search(edge, middle + 1, last, 1 - axis, found, looks, upper, hi);
}

}  // namespace kerf::core
