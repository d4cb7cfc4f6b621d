#include "common/caps/outline_loops.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "common/geometry/dominant_axis.h"
#include "common/mesh/position_order.h"

namespace kerf::core {

namespace {

/// -1, 0 or 1 by x, then y, then z.
int compare(const glm::vec3& a, const glm::vec3& b)
{
    if (same_position(a, b)) return 0;
    return lexicographically_less(a, b) ? -1 : 1;
}

}  // namespace

std::span<const std::array<std::uint32_t, 2>> OppositeEdges::find(std::size_t point_count,
                                                                  std::span<const OutlineEdge> edges)
{
    out_.begin(point_count);
    for (std::uint32_t e = 0; e < edges.size(); ++e) out_.add(edges[e].from, e);
    // Edges that may have a reverse.
    some_.clear();
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        const std::uint32_t back = out_[edges[e].to];
        if (back == kNone) continue;
        if (back == EdgeAtPoint::kSeveral || edges[back].to == edges[e].from) some_.push_back(e);
    }
    pairs_.clear();
    if (some_.empty()) return pairs_;
    const auto ends = [&](std::uint32_t e) { return std::minmax(edges[e].from, edges[e].to); };
    std::sort(some_.begin(), some_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::tuple(ends(a), edges[a].from, edges[a].source, a) <
               std::tuple(ends(b), edges[b].from, edges[b].source, b);
    });
    for (std::size_t first = 0, last; first < some_.size(); first = last) {
        std::size_t middle = first;
        for (last = first; last < some_.size() && ends(some_[last]) == ends(some_[first]); ++last)
            if (edges[some_[last]].from == edges[some_[first]].from) ++middle;
        for (std::size_t forth = first, back = middle; forth < middle && back < last; ++forth, ++back)
            pairs_.push_back({some_[forth], some_[back]});
    }
    return pairs_;
}

const DividedOutline& OutlineDivider::divide(const Plane& plane, std::span<const glm::vec3> points,
                                             std::span<const OutlineEdge> edges, std::span<const std::uint64_t> tags)
{
    begin(plane.normal[dominant_axis(plane.normal)] < 0.0, points, edges, tags);
    find_nodes();
    order_.resize(nodes_.size());
    std::iota(order_.begin(), order_.end(), 0u);
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) { return comes_before(a, b); });
    for (const std::uint32_t node : order_)
        for (std::uint32_t i = nodes_[node].arriving(); i < nodes_[node].leaving(); ++i) follow(node);
    for (const std::uint32_t node : order_) follow(node);
    for (std::uint32_t e = 0; e < edges_.size(); ++e)
        if (is_used_[e] == 0) go_round(e);
    return divided_;
}

void OutlineDivider::begin(bool backwards, std::span<const glm::vec3> points, std::span<const OutlineEdge> edges,
                           std::span<const std::uint64_t> tags)
{
    backwards_ = backwards;
    points_ = points;
    edges_ = edges;
    tags_ = tags;
    ends_.clear();
    nodes_.clear();
    divided_.edges.clear();
    divided_.paths.clear();
    divided_.edges.reserve(edges.size());
    out_.begin(points.size());
    in_.begin(points.size());
    is_used_.assign(edges.size(), 0);
    head_.assign(edges.size(), kNone);
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
        out_.add(edges[e].from, e);
        in_.add(edges[e].to, e);
    }
}

/// One edge arrives and one of its tag leaves.
bool OutlineDivider::passes(std::uint32_t point) const
{
    const std::uint32_t in = in_[point], out = out_[point];
    return in < EdgeAtPoint::kSeveral && out < EdgeAtPoint::kSeveral && tag(in) == tag(out);
}

const glm::vec3& OutlineDivider::far_position(const End& end) const
{
    const OutlineEdge& edge = edges_[end.edge];
    return points_[edge.from == end.point ? edge.to : edge.from];
}

/// -1, 0 or 1: edges that leave first, by where they lead, then by their sources.
int OutlineDivider::compare_ends(const End& a, const End& b) const
{
    if (a.arrives != b.arrives) return a.arrives ? 1 : -1;
    if (const int order = compare(far_position(a), far_position(b)); order != 0) return order;
    const std::uint32_t p = edges_[a.edge].source, q = edges_[b.edge].source;
    return p == q ? 0 : (p < q ? -1 : 1);
}

void OutlineDivider::find_nodes()
{
    for (std::uint32_t e = 0; e < edges_.size(); ++e) {
        if (!passes(edges_[e].from)) ends_.push_back({edges_[e].from, tag(e), backwards_, e});
        if (!passes(edges_[e].to)) ends_.push_back({edges_[e].to, tag(e), !backwards_, e});
    }
    if (ends_.empty()) return;
    std::sort(ends_.begin(), ends_.end(), [&](const End& a, const End& b) {
        if (a.point != b.point) return a.point < b.point;
        if (a.tag != b.tag) return a.tag < b.tag;
        const int order = compare_ends(a, b);
        return order != 0 ? order < 0 : a.edge < b.edge;
    });
    for (std::uint32_t first = 0, last; first < ends_.size(); first = last) {
        std::uint32_t middle = first;
        for (last = first;
             last < ends_.size() && ends_[last].point == ends_[first].point && ends_[last].tag == ends_[first].tag;
             ++last) {
            if (ends_[last].arrives)
                head_[ends_[last].edge] = static_cast<std::uint32_t>(nodes_.size());
            else
                ++middle;
        }
        nodes_.push_back({ends_[first].point, first, middle, last, first});
    }
}

bool OutlineDivider::comes_before(std::uint32_t a, std::uint32_t b) const
{
    const Node &p = nodes_[a], &q = nodes_[b];
    if (const int order = compare(points_[p.point], points_[q.point]); order != 0) return order < 0;
    for (std::uint32_t i = p.first, j = q.first; i < p.last && j < q.last; ++i, ++j)
        if (const int order = compare_ends(ends_[i], ends_[j]); order != 0) return order < 0;
    if (p.last - p.first != q.last - q.first) return p.last - p.first < q.last - q.first;
    return a < b;
}

/// Takes the path that begins at a node on until no edge is left. Loops leave it on the way.
void OutlineDivider::follow(std::uint32_t node)
{
    path_.clear();
    passed_.clear();
    while (nodes_[node].next < nodes_[node].middle) {
        nodes_[node].place = static_cast<std::uint32_t>(path_.size());
        passed_.push_back(node);
        node = follow_strand(ends_[nodes_[node].next++].edge);
        const std::uint32_t place = nodes_[node].place;
        if (place == kNone) continue;
        emit(place, true);
        while (nodes_[node].place != kNone) {
            nodes_[passed_.back()].place = kNone;
            passed_.pop_back();
        }
    }
    if (!path_.empty()) emit(0, false);
    for (const std::uint32_t n : passed_) nodes_[n].place = kNone;
}

/// Adds the edges from one node to the next to the path; returns that node.
std::uint32_t OutlineDivider::follow_strand(std::uint32_t edge)
{
    for (;;) {
        is_used_[edge] = 1;
        path_.push_back(edge);
        if (head_[edge] != kNone) return head_[edge];
        edge = backwards_ ? in_[edges_[edge].from] : out_[edges_[edge].to];
    }
}

/// A loop that passes no node, as it runs.
void OutlineDivider::go_round(std::uint32_t first)
{
    const std::size_t begin = divided_.edges.size();
    std::uint32_t edge = first;
    do {
        is_used_[edge] = 1;
        divided_.edges.push_back(edge);
        edge = out_[edges_[edge].to];
    } while (edge != first);
    divided_.paths.push_back({begin, divided_.edges.size() - begin, true});
}

/// Removes the path from `first` on and records it as a loop or a chain.
void OutlineDivider::emit(std::size_t first, bool closed)
{
    const auto begin = path_.begin() + static_cast<std::ptrdiff_t>(first);
    divided_.paths.push_back({divided_.edges.size(), path_.size() - first, closed});
    if (backwards_) std::reverse(begin, path_.end());
    divided_.edges.insert(divided_.edges.end(), begin, path_.end());
    path_.resize(first);
}

std::vector<std::array<std::uint32_t, 2>> opposite_edges(std::size_t point_count, std::span<const OutlineEdge> edges)
{
    OppositeEdges search;
    const std::span<const std::array<std::uint32_t, 2>> pairs = search.find(point_count, edges);
    return {pairs.begin(), pairs.end()};
}

DividedOutline divide_outline(const Plane& plane, std::span<const glm::vec3> points, std::span<const OutlineEdge> edges,
                              std::span<const std::uint64_t> tags)
{
    return OutlineDivider().divide(plane, points, edges, tags);
}

}  // namespace kerf::core
