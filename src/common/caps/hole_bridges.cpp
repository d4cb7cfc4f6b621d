#include "common/caps/hole_bridges.h"

#include <algorithm>
#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <tuple>

#include "common/geometry/turn.h"

// Where a bridge leads decides only whether triangles are found: whatever is covered by triangles that all run
// counter-clockwise is covered right. So the crossing of a ray with an edge may be rounded.

namespace kerf::core {

namespace {

/// Each row is so many times as long as the one before.
constexpr double kNextRow = 8.0;

}  // namespace

bool HoleBridger::build(const CapOutline& outline, Rings& rings, std::uint64_t& most_looks)
{
    looks_left_ = most_looks;
    begin(outline);
    const bool built = bridge_all(rings);
    most_looks = looks_left_;
    return built;
}

void HoleBridger::begin(const CapOutline& outline)
{
    outline_ = &outline;
    const Index n = static_cast<Index>(outline.points.size());
    after_ = parter_.part(outline).after;
    before_.resize(n);
    point_.resize(n);
    link_.resize(n);
    for (Index i = 0; i < n; ++i) {
        before_[after_[i]] = i;
        point_[i] = i;
        link_[i] = CapLink::to_outline(i);
    }
    loop_of_.assign(n, kNone);
    starts_.clear();
    for (Index first = 0; first < n; ++first) {
        if (loop_of_[first] != kNone) continue;
        for (Index i = first; loop_of_[i] == kNone; i = after_[i]) loop_of_[i] = static_cast<Index>(starts_.size());
        starts_.push_back(first);
    }
    successor_ = after_;
    next_copy_.assign(n, kNone);
}

bool HoleBridger::bridge_all(Rings& rings)
{
    holes_.clear();
    is_joined_.clear();
    for (Index loop = 0; loop < starts_.size(); ++loop) {
        is_joined_.push_back(twice_area(loop) >= 0.0);
        if (is_joined_[loop] == 0) holes_.push_back(leftmost(loop));
    }
    std::sort(holes_.begin(), holes_.end(), [&](Index a, Index b) { return is_left_of(a, b); });
    if (!holes_.empty()) {
        measure_rows();
        edges_.build(outline_->points.size(), [&](std::size_t i, Box2& box) {
            for (const Index end : {Index(i), successor_[i]}) box.add(at(end).x, at(end).y);
        });
    }
    rings.bridge_count = 0;
    for (const Index hole : holes_) {
        const Index seen = seen_from(hole);
        if (seen == kNone) return false;
        add_bridge(rings.bridge_count++, seen, hole);
        is_joined_[loop_of_[hole]] = 1;
    }
    collect(rings);
    return true;
}

/// The first row is as long as points are apart if they are spread over the outline's box.
void HoleBridger::measure_rows()
{
    Box2 box;
    for (const glm::dvec2& p : outline_->points) box.add(p.x, p.y);
    left_end_ = box.lo_x;
    const double width = box.hi_x - box.lo_x;
    first_row_ = std::max(width / std::sqrt(double(outline_->points.size())), width * 1e-3);
}

bool HoleBridger::is_left_of(Index a, Index b) const
{
    return std::tie(at(a).x, at(a).y, a) < std::tie(at(b).x, at(b).y, b);
}

double HoleBridger::twice_area(Index loop) const
{
    const Index first = starts_[loop];
    double twice = 0.0;
    for (Index i = successor_[first]; i != first; i = successor_[i]) {
        const glm::dvec2 p = at(i) - at(first), q = at(successor_[i]) - at(first);
        twice += p.x * q.y - p.y * q.x;
    }
    return twice;
}

Index HoleBridger::leftmost(Index loop) const
{
    Index found = starts_[loop];
    for (Index i = successor_[found]; i != starts_[loop]; i = successor_[i])
        if (is_left_of(i, found)) found = i;
    return found;
}

/// A corner that the leftmost point of a hole sees; kNone if there is none.
Index HoleBridger::seen_from(Index hole)
{
    const glm::dvec2& p = at(hole);
    // It is near as a rule: rows that get longer are looked through until one holds it.
    double hit = 0.0;
    Index edge = kNone;
    for (double length = first_row_;; length *= kNextRow) {
        const double end = p.x - length;
        const bool is_last = !(end > left_end_);
        if (!find_edge_on_the_left(p, is_last ? left_end_ : end, hit, edge)) return kNone;
        if (edge != kNone && (is_last || hit >= end)) break;
        if (is_last) return kNone;
    }
    const Index end = at(edge).x < at(successor_[edge]).x ? edge : successor_[edge];
    // Corners between hide it: of these the one nearest to the ray, by its angle, is seen.
    const Index corner = nearest_between(hole, {hit, p.y}, end);
    return looks_left_ == 0 ? kNone : corner;
}

/// The nearest edge on the left of a place, of those that come as far to the right as `row_end`, that has the inside on
/// its right: it runs downwards. False if no look is left.
bool HoleBridger::find_edge_on_the_left(const glm::dvec2& p, double row_end, double& hit, Index& edge)
{
    Box2 row;
    row.add(row_end, p.y);
    row.add(p.x, p.y);
    edge = kNone;
    return !edges_.any(row, [&](std::size_t e) {
        if (looks_left_ == 0) return true;
        --looks_left_;
        const glm::dvec2 &a = at(Index(e)), &b = at(successor_[e]);
        if (is_joined_[loop_of_[e]] == 0 || !(a.y > p.y && b.y <= p.y) || turn(a, b, p) < 0.0) return false;
        const double x = std::min(a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x), p.x);
        if (edge == kNone || x > hit) {
            hit = x;
            edge = static_cast<Index>(e);
        }
        return false;
    });
}

/// The corner in the triangle of a hole's leftmost point, the place that its ray hits, and an end of the edge there,
/// whose bridge to the point has the least angle with the ray.
Index HoleBridger::nearest_between(Index hole, const glm::dvec2& hit, Index end)
{
    const glm::dvec2 &p = at(hole), &q = at(end);
    const bool is_above = q.y > p.y;
    const glm::dvec2 &first = is_above ? p : hit, &last = is_above ? hit : p;
    Box2 box;
    for (const glm::dvec2& corner : {p, hit, q}) box.add(corner.x, corner.y);
    const auto slope = [&](const glm::dvec2& r) {
        return r.x < p.x ? std::abs(r.y - p.y) / (p.x - r.x) : std::numeric_limits<double>::infinity();
    };
    Index best = copy_towards(end, hole);
    double least = best == kNone ? std::numeric_limits<double>::infinity() : slope(q);
    edges_.any(box, [&](std::size_t i) {
        if (looks_left_ == 0) return true;
        --looks_left_;
        const glm::dvec2& r = at(Index(i));
        if (is_joined_[loop_of_[i]] == 0 || r.x >= p.x || (is_above ? r.y < p.y : r.y > p.y)) return false;
        if (turn(first, q, r) < 0.0 || turn(q, last, r) < 0.0) return false;
        const double own = slope(r);
        if (best != kNone && (own > least || (own == least && r.x <= at(best).x))) return false;
        if (const Index corner = copy_towards(Index(i), hole); corner != kNone) {
            best = corner;
            least = own;
        }
        return false;
    });
    return best == kNone ? end : best;
}

/// Of the corners at a place the one whose inside a bridge to the hole begins in; kNone if there is none.
Index HoleBridger::copy_towards(Index point, Index hole) const
{
    const glm::dvec2& p = at(hole);
    for (Index corner = point; corner != kNone; corner = next_copy_[corner]) {
        const glm::dvec2 &a = at(before_[corner]), &b = at(corner), &c = at(after_[corner]);
        const bool after_first = turn(a, b, p) > 0.0, before_last = turn(b, c, p) > 0.0;
        if (turn(a, b, c) > 0.0 ? after_first && before_last : after_first || before_last) return corner;
    }
    return kNone;
}

void HoleBridger::add_bridge(std::size_t bridge, Index corner, Index hole)
{
    const Index corner_back = copy(corner), hole_back = copy(hole);
    join(corner_back, after_[corner], link_[corner]);
    join(before_[hole], hole_back, link_[before_[hole]]);
    join(corner, hole, bridge_link(*outline_, bridge, 0));
    join(hole_back, corner_back, bridge_link(*outline_, bridge, 1));
}

Index HoleBridger::copy(Index corner)
{
    const Index made = static_cast<Index>(point_.size());
    point_.push_back(point_[corner]);
    before_.push_back(kNone);
    after_.push_back(kNone);
    link_.emplace_back();
    next_copy_.push_back(next_copy_[corner]);
    next_copy_[corner] = made;
    return made;
}

void HoleBridger::join(Index from, Index to, CapLink link)
{
    after_[from] = to;
    before_[to] = from;
    link_[from] = link;
}

void HoleBridger::collect(Rings& rings)
{
    rings.points.clear();
    rings.links.clear();
    rings.starts.clear();
    is_taken_.assign(point_.size(), 0);
    for (Index first = 0; first < point_.size(); ++first) {
        if (is_taken_[first] != 0) continue;
        rings.starts.push_back(static_cast<Index>(rings.points.size()));
        for (Index corner = first; is_taken_[corner] == 0; corner = after_[corner]) {
            is_taken_[corner] = 1;
            rings.points.push_back(point_[corner]);
            rings.links.push_back(link_[corner]);
        }
    }
    rings.starts.push_back(static_cast<Index>(rings.points.size()));
    rings.shared = parter_.shared();
}

void HoleBridger::join_triangles(const CapOutline& outline, const Rings& rings, CapMesh& cap)
{
    if (rings.bridge_count == 0) return;
    const Index n = static_cast<Index>(outline.points.size());
    sides_.assign(2 * rings.bridge_count, CapLink());
    for (Index t = 0; t < cap.triangles.size(); ++t)
        for (Index i = 0; i < 3; ++i)
            if (const CapLink link = cap.triangles[t].link[i]; link.is_outline() && link.outline_edge() >= n)
                sides_[link.outline_edge() - n] = CapLink::to_triangle(t, i);
    for (std::size_t bridge = 0; bridge < rings.bridge_count; ++bridge)
        cap.connect(sides_[2 * bridge], sides_[2 * bridge + 1]);
}

}  // namespace kerf::core
