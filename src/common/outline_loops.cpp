#include "common/outline_loops.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <unordered_map>

#include "common/cut_geometry.h"
#include "common/outgoing_edges.h"

namespace kerf {

namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Removes pairs of opposite edges. They bound the same part on either side: whatever has the same two points is joined
/// by them.
void cancel_opposite_edges(std::vector<OutlineEdge>& edges)
{
    std::sort(edges.begin(), edges.end(), [](const OutlineEdge& a, const OutlineEdge& b) {
        return std::tuple(std::minmax(a.from, a.to), a.from, a.part) <
               std::tuple(std::minmax(b.from, b.to), b.from, b.part);
    });
    std::size_t kept = 0;
    for (std::size_t first = 0, last; first < edges.size(); first = last) {
        const auto ends = std::minmax(edges[first].from, edges[first].to);
        last = first;
        while (last < edges.size() && std::minmax(edges[last].from, edges[last].to) == ends) ++last;
        std::size_t middle = first;
        while (middle < last && edges[middle].from == edges[first].from) ++middle;
        const std::size_t forth = middle - first, back = last - middle, gone = std::min(forth, back);
        for (std::size_t i = first + gone; i < middle; ++i) edges[kept++] = edges[i];
        for (std::size_t i = middle + gone; i < last; ++i) edges[kept++] = edges[i];
    }
    edges.resize(kept);
}

/// Sorts points whose positions are equal, which have no order that all back ends have, by where their edges lead.
void sort_points_of_one_place(std::span<const glm::vec3> points, std::span<const OutlineEdge> edges,
                              std::vector<std::uint32_t>& order)
{
    struct End
    {
        bool leaves;
        glm::vec3 other;
    };
    const auto is_less = [](const End& a, const End& b) {
        if (a.leaves != b.leaves) return a.leaves;
        return !same_position(a.other, b.other) && lexicographically_less(a.other, b.other);
    };
    std::unordered_map<std::uint32_t, std::vector<End>> ends;  // nearly always empty
    for (std::size_t i = 1; i < order.size(); ++i)
        if (same_position(points[order[i - 1]], points[order[i]])) {
            ends[order[i - 1]];
            ends[order[i]];
        }
    if (ends.empty()) return;
    for (const OutlineEdge& edge : edges) {
        if (const auto at = ends.find(edge.from); at != ends.end()) at->second.push_back({true, points[edge.to]});
        if (const auto at = ends.find(edge.to); at != ends.end()) at->second.push_back({false, points[edge.from]});
    }
    for (auto& [point, own] : ends) std::sort(own.begin(), own.end(), is_less);
    for (std::size_t first = 0, last; first < order.size(); first = last) {
        last = first + 1;
        while (last < order.size() && same_position(points[order[first]], points[order[last]])) ++last;
        if (last - first < 2) continue;
        std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.begin() + static_cast<std::ptrdiff_t>(last),
                  [&](std::uint32_t a, std::uint32_t b) {
                      const std::vector<End>&of_a = ends.at(a), &of_b = ends.at(b);
                      return std::lexicographical_compare(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), is_less);
                  });
    }
}

}  // namespace

SortedOutline::SortedOutline(std::span<const glm::vec3> points, std::span<const OutlineEdge> edges)
    : edges_(edges.begin(), edges.end())
{
    std::vector<std::uint32_t> order(points.size()), rank(points.size());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        if (same_position(points[a], points[b])) return a < b;
        return lexicographically_less(points[a], points[b]);
    });
    sort_points_of_one_place(points, edges, order);
    positions_.reserve(points.size());
    for (const std::uint32_t point : order) {
        rank[point] = static_cast<std::uint32_t>(positions_.size());
        positions_.push_back(points[point]);
    }
    for (OutlineEdge& edge : edges_) {
        edge.from = rank[edge.from];
        edge.to = rank[edge.to];
    }
    std::erase_if(edges_, [](const OutlineEdge& edge) { return edge.from == edge.to; });
    sort_by_points();
    if (some_run_forth_and_back()) {
        cancel_opposite_edges(edges_);
        sort_by_points();
    }
}

void SortedOutline::sort_by_points()
{
    row_.assign(positions_.size() + 1, 0);
    for (const OutlineEdge& edge : edges_) ++row_[edge.from + 1];
    for (std::size_t i = 1; i < row_.size(); ++i) row_[i] += row_[i - 1];
    std::vector<OutlineEdge> sorted(edges_.size());
    std::vector<std::uint32_t> fill(row_.begin(), row_.end() - 1);
    for (const OutlineEdge& edge : edges_) sorted[fill[edge.from]++] = edge;
    edges_.swap(sorted);
    // Nearly always one edge leaves a point.
    for (std::size_t i = 0; i + 1 < row_.size(); ++i) {
        if (row_[i + 1] - row_[i] < 2) continue;
        has_joints_ = true;
        std::sort(
            edges_.begin() + row_[i], edges_.begin() + row_[i + 1],
            [](const OutlineEdge& a, const OutlineEdge& b) { return std::tie(a.to, a.part) < std::tie(b.to, b.part); });
    }
}

bool SortedOutline::some_run_forth_and_back() const
{
    return std::any_of(edges_.begin(), edges_.end(), [&](const OutlineEdge& edge) {
        // Edges that leave one point are sorted by where they end.
        const auto last = edges_.begin() + row_[edge.to + 1];
        const auto back = std::lower_bound(edges_.begin() + row_[edge.to], last, edge.from,
                                           [](const OutlineEdge& other, std::uint32_t to) { return other.to < to; });
        return back != last && back->to == edge.from;
    });
}

std::vector<OutlineLoop> SortedOutline::loops(std::size_t side) const
{
    OutgoingEdges outgoing(
        positions_.size(), edges_.size(), [&](std::uint32_t edge) { return edges_[edge].from; },
        [&](std::uint32_t edge) { return edges_[edge].part[side]; });

    std::vector<OutlineLoop> loops;
    std::vector<std::uint32_t> place(positions_.size(), kNone);  // where on the path a point's outgoing edge is
    std::vector<std::uint32_t> path;
    for (std::uint32_t first = 0; first < edges_.size(); ++first) {
        if (outgoing.is_used(first)) continue;
        const std::uint32_t part = edges_[first].part[side];
        path.clear();
        for (std::uint32_t edge = first; edge != kNone;) {
            outgoing.use(edge);
            place[edges_[edge].from] = static_cast<std::uint32_t>(path.size());
            path.push_back(edge);
            const std::uint32_t to = edges_[edge].to;
            if (place[to] != kNone) {
                // Back at a point of the path: what lies between is a loop that visits no point twice.
                OutlineLoop& loop = loops.emplace_back();
                loop.part = part;
                const std::size_t begin = place[to];
                for (std::size_t i = begin; i < path.size(); ++i) {
                    loop.points.push_back(edges_[path[i]].from);
                    place[edges_[path[i]].from] = kNone;
                }
                path.resize(begin);
            }
            edge = outgoing.next(to, part);
        }
        for (const std::uint32_t edge : path) place[edges_[edge].from] = kNone;
    }
    return loops;
}

}  // namespace kerf
