#include "common/caps/ear_clipper.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/geometry/turn.h"

namespace kerf::core {

namespace {

/// How far rounding moves a point of a section along an axis, for each unit of the largest coordinate: one unit in the last
/// place. A cap that is turned over by that is as good as its outline (caps_exceed_section()).
constexpr double kTurnedByRounding = std::numeric_limits<float>::epsilon();

}  // namespace

bool EarClipper::clip_in_layers(CapMesh& cap, std::uint64_t& looks_left)
{
    places_may_repeat_ = false;
    least_share_ = 64;
    looks_left_ = looks_left;
    bool closed = ring_.size() >= 3;
    while (closed && ring_.size() > 3) closed = clip_layer(cap) && looks_left_ > 0;
    closed = closed && add_last_triangle(cap);
    looks_left = looks_left_;
    return closed;
}

bool EarClipper::clip_with_patience(CapMesh& cap, std::uint64_t& looks_left)
{
    places_may_repeat_ = true;
    least_share_ = 8;
    looks_left_ = looks_left;
    bool closed = ring_.size() >= 3;
    while (closed && ring_.size() > 3) closed = (clip_layer(cap) || clip_one_by_one(cap)) && looks_left_ > 0;
    closed = closed && add_last_triangle(cap);
    looks_left = looks_left_;
    return closed;
}

/// One pass. It judges corners as they are at its beginning: clipping an ear makes no corner reflex, and ears that are not
/// neighbours do not overlap.
bool EarClipper::clip_layer(CapMesh& cap)
{
    const std::size_t n = ring_.size();
    const auto before = [&](std::size_t i) { return i == 0 ? n - 1 : i - 1; };
    const auto after = [&](std::size_t i) { return i + 1 == n ? 0 : i + 1; };
    corners_.resize(n);
    tree_.clear(n);
    for (std::size_t i = 0; i < n; ++i) {
        corners_[i] = corner_between(before(i), i, after(i));
        if (corners_[i] != Corner::convex) tree_.put(i, ring_.points[i]);
    }
    tree_.build();

    clipped_.resize(n);
    bool last_clipped = false, first_clipped = false;
    std::size_t left = n;
    for (std::size_t i = 0; i < n; ++i) {
        const bool free = !last_clipped && !(i + 1 == n && first_clipped) && left > 3;
        last_clipped = free && corners_[i] != Corner::reflex &&
                       is_ear(before(i), i, after(i), [](std::size_t corner) { return corner; });
        clipped_[i] = last_clipped;
        if (last_clipped) {
            if (i == 0) first_clipped = true;
            --left;
        }
    }
    for (std::size_t i = 0; i < n; ++i)
        if (clipped_[i] != 0) ring_.edges[before(i)] = add_triangle(cap, before(i), i, after(i));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < n; ++i) {
        if (clipped_[i] != 0) continue;
        ring_.points[kept] = ring_.points[i];
        ring_.numbers[kept] = ring_.numbers[i];
        ring_.edges[kept] = ring_.edges[i];
        ++kept;
    }
    ring_.resize(kept);
    return kept < n && (n - kept) * least_share_ >= n;
}

bool EarClipper::clip_one_by_one(CapMesh& cap)
{
    link_corners();
    const auto corner_at = [this](std::size_t i) { return std::size_t{order_[i]}; };
    // When half of the corners are clipped, a tree of those that are left is worth its price.
    const std::size_t enough = std::max<std::size_t>(3, ring_.size() / 2);
    std::size_t left = ring_.size(), left_before = left + 1;
    // A round is over when no corner waits. What stood in the way of an ear may have been clipped since.
    while (left > enough && left < left_before && looks_left_ > 0) {
        left_before = left;
        queue_.clear();
        for (Index i = 0; i < ring_.size(); ++i)
            if (is_left(i)) wait(i);
        for (std::size_t next = 0; next < queue_.size() && left > enough; ++next) {
            const Index b = queue_[next];
            is_waiting_[b] = 0;
            if (!is_left(b) || corner_between(before_[b], b, after_[b]) == Corner::reflex) continue;
            if (!is_ear(before_[b], b, after_[b], corner_at)) continue;
            clip_corner(b, cap);
            --left;
        }
    }
    const bool clipped_any = left < ring_.size();
    keep_what_is_left();
    return clipped_any;
}

void EarClipper::keep_what_is_left()
{
    std::size_t kept = 0;
    for (Index i = 0; i < ring_.size(); ++i) {
        if (!is_left(i)) continue;
        ring_.points[kept] = ring_.points[i];
        ring_.numbers[kept] = ring_.numbers[i];
        ring_.edges[kept] = ring_.edges[i];
        ++kept;
    }
    ring_.resize(kept);
}

void EarClipper::link_corners()
{
    const Index n = static_cast<Index>(ring_.size());
    before_.resize(n);
    after_.resize(n);
    corners_.resize(n);
    for (Index i = 0; i < n; ++i) {
        before_[i] = i == 0 ? n - 1 : i - 1;
        after_[i] = i + 1 == n ? 0 : i + 1;
        corners_[i] = corner_between(before_[i], i, after_[i]);
    }
    // If loops do not cross, a corner never becomes reflex.
    order_.clear();
    for (Index i = 0; i < n; ++i)
        if (corners_[i] != Corner::convex) order_.push_back(i);
    tree_.clear(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) tree_.put(i, ring_.points[order_[i]]);
    tree_.build();
    is_waiting_.assign(n, 0);
}

void EarClipper::clip_corner(Index b, CapMesh& cap)
{
    const Index a = before_[b], c = after_[b];
    ring_.edges[a] = add_triangle(cap, a, b, c);
    after_[a] = c;
    before_[c] = a;
    after_[b] = b;
    for (const Index i : {a, c}) {
        corners_[i] = corner_between(before_[i], i, after_[i]);
        wait(i);
    }
}

void EarClipper::wait(Index i)
{
    if (is_waiting_[i] != 0) return;
    is_waiting_[i] = 1;
    queue_.push_back(i);
}

EarClipper::Corner EarClipper::corner_between(std::size_t ia, std::size_t ib, std::size_t ic) const
{
    const glm::dvec2 &a = ring_.points[ia], &b = ring_.points[ib], &c = ring_.points[ic];
    const double side = turn(a, b, c);
    if (side != 0.0) return side > 0.0 ? Corner::convex : Corner::reflex;
    // The three lie on a line, so both products have one sign, and rounding can't change it.
    return glm::dot(b - a, c - b) < 0.0 && a != c ? Corner::folded : Corner::reflex;
}

template <class CornerAt>
bool EarClipper::is_ear(std::size_t ia, std::size_t ib, std::size_t ic, CornerAt corner_at)
{
    const glm::dvec2 &a = ring_.points[ia], &b = ring_.points[ib], &c = ring_.points[ic];
    Box2 box;
    for (const glm::dvec2* p : {&a, &b, &c}) box.add(p->x, p->y);
    return !tree_.any(box, looks_left_, [&](std::size_t item) {
        const std::size_t i = corner_at(item);
        if (corners_[i] == Corner::convex || i == ia || i == ib || i == ic) return false;
        const glm::dvec2& p = ring_.points[i];
        if (turn(a, b, p) < 0.0 || turn(b, c, p) < 0.0 || turn(c, a, p) < 0.0) return false;
        return !places_may_repeat_ || (p != a && p != b && p != c);
    });
}

/// Returns its edge from c to a, as seen from the rest of the ring.
CapLink EarClipper::add_triangle(CapMesh& cap, std::size_t a, std::size_t b, std::size_t c)
{
    const Index t = static_cast<Index>(cap.triangles.size());
    cap.triangles.push_back({{ring_.numbers[a], ring_.numbers[b], ring_.numbers[c]}});
    cap.connect(CapLink::to_triangle(t, 0), ring_.edges[a]);
    cap.connect(CapLink::to_triangle(t, 1), ring_.edges[b]);
    return CapLink::to_triangle(t, 2);
}

/// Whether the three corners that are left, each moved by kTurnedByRounding, may run counter-clockwise.
bool EarClipper::is_turned_by_rounding(double twice_area) const
{
    double largest = 0.0, longest = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 &from = ring_.points[i], &to = ring_.points[(i + 1) % 3];
        largest = std::max({largest, std::abs(from.x), std::abs(from.y)});
        longest = std::max(longest, glm::distance(from, to));
    }
    return std::abs(twice_area) <= 2.0 * kTurnedByRounding * largest * longest;
}

bool EarClipper::add_last_triangle(CapMesh& cap)
{
    // A triangle of no area closes a ring that folds back on itself, but needs three places.
    const glm::dvec2 &a = ring_.points[0], &b = ring_.points[1], &c = ring_.points[2];
    const double side = turn(a, b, c);
    if (side < 0.0) {
        if (!is_turned_by_rounding(side)) return false;
        cap.turns_over = true;
    }
    if (places_may_repeat_ && (a == b || b == c || c == a)) return false;
    cap.connect(add_triangle(cap, 0, 1, 2), ring_.edges[2]);
    return true;
}

}  // namespace kerf::core
