#include "common/io/polygon.h"

#include <cmath>
#include <glm/common.hpp>
#include <numeric>
#include <vector>

#include "common/geometry/dominant_axis.h"

namespace kerf::core::io {

namespace {

struct Point2
{
    double x = 0.0, y = 0.0;
};

/// Twice the signed area of a triangle; positive if counter-clockwise.
double area2(const Point2& a, const Point2& b, const Point2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Normal of the polygon by Newell's method, its length twice the area. Relative to the first corner, so that a small
/// face far from the origin keeps its digits.
glm::dvec3 newell_normal(std::span<const std::uint32_t> indices, std::span<const Vertex> vertices)
{
    const glm::dvec3 origin(vertices[indices[0]].position);
    glm::dvec3 n(0.0);
    glm::dvec3 a = glm::dvec3(vertices[indices.back()].position) - origin;
    for (const std::uint32_t index : indices) {
        const glm::dvec3 b = glm::dvec3(vertices[index].position) - origin;
        n.x += (a.y - b.y) * (a.z + b.z);
        n.y += (a.z - b.z) * (a.x + b.x);
        n.z += (a.x - b.x) * (a.y + b.y);
        a = b;
    }
    return n;
}

/// The corners seen along the axis in which the normal is longest, so that the outline runs counter-clockwise.
std::vector<Point2> project(std::span<const std::uint32_t> indices, std::span<const Vertex> vertices)
{
    const glm::dvec3 n = newell_normal(indices, vertices);
    const int axis = dominant_axis(n);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    const bool mirrored = n[axis] < 0.0;
    std::vector<Point2> points;
    points.reserve(indices.size());
    for (const std::uint32_t index : indices) {
        const glm::dvec3 p(vertices[index].position);
        points.push_back(mirrored ? Point2{p[v], p[u]} : Point2{p[u], p[v]});
    }
    return points;
}

/// True if no corner turns right and the outline goes around once: every triangle of the fan then has its right side
/// up. The fan's own triangles must not be flat either; a flat one would leave a better diagonal unused.
bool is_convex(const std::vector<Point2>& p)
{
    const std::size_t n = p.size();
    for (std::size_t i = 0; i < n; ++i)
        if (area2(p[i], p[(i + 1) % n], p[(i + 2) % n]) < 0.0) return false;
    int sign_changes = 0;  // of the x direction; going around once makes two
    int last = 0, first = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double dx = p[(i + 1) % n].x - p[i].x;
        const int direction = dx > 0.0 ? 1 : (dx < 0.0 ? -1 : 0);
        if (direction == 0) continue;
        if (last != 0 && direction != last) ++sign_changes;
        if (first == 0) first = direction;
        last = direction;
    }
    sign_changes += first != last;
    if (sign_changes > 2) return false;
    for (std::size_t i = 2; i < n; ++i)
        if (!(area2(p[0], p[i - 1], p[i]) > 0.0)) return false;
    return true;
}

/// Clips ears off an outline; the state of a corner is kept until one of its neighbours is clipped.
class EarClipper
{
public:
    explicit EarClipper(const std::vector<Point2>& points) : p_(points), next_(points.size()), previous_(points.size())
    {
        const std::size_t n = p_.size();
        for (std::size_t i = 0; i < n; ++i) {
            next_[i] = (i + 1) % n;
            previous_[i] = (i + n - 1) % n;
        }
        is_reflex_.resize(n);
        for (std::size_t i = 0; i < n; ++i) is_reflex_[i] = turn(i) <= 0.0;
        is_ear_.resize(n);
        for (std::size_t i = 0; i < n; ++i) is_ear_[i] = find_ear(i);
    }

    template <class Emit>
    void run(const Emit& emit)
    {
        std::size_t corner = 0;
        for (std::size_t left = p_.size(); left > 3; --left) {
            corner = choose(corner, left);
            const std::size_t before = previous_[corner], after = next_[corner];
            emit(before, corner, after);
            next_[before] = after;
            previous_[after] = before;
            update(before);
            update(after);
            corner = after;
        }
        emit(previous_[corner], corner, next_[corner]);
    }

private:
    double turn(std::size_t i) const { return area2(p_[previous_[i]], p_[i], p_[next_[i]]); }

    void update(std::size_t i)
    {
        is_reflex_[i] = turn(i) <= 0.0;
        is_ear_[i] = find_ear(i);
    }

    /// An ear turns left and has no other corner inside or on it. Only corners that turn right can be there.
    bool find_ear(std::size_t i) const
    {
        if (is_reflex_[i]) return false;
        const std::size_t before = previous_[i], after = next_[i];
        const Point2 &a = p_[before], &b = p_[i], &c = p_[after];
        for (std::size_t j = next_[after]; j != before; j = next_[j]) {
            if (!is_reflex_[j]) continue;
            const Point2& q = p_[j];
            // A corner at the place of one of the ear's own does not block it: holes are joined to outlines that way.
            if (same(q, a) || same(q, b) || same(q, c)) continue;
            if (area2(a, b, q) >= 0.0 && area2(b, c, q) >= 0.0 && area2(c, a, q) >= 0.0) return false;
        }
        return true;
    }

    static bool same(const Point2& a, const Point2& b) { return a.x == b.x && a.y == b.y; }

    /// The next ear from `start` on; without one (the outline crosses itself) the first corner that turns left, or a
    /// flat one, or any.
    std::size_t choose(std::size_t start, std::size_t left) const
    {
        std::size_t fallback = start;
        double best = -1.0;
        std::size_t i = start;
        for (std::size_t k = 0; k < left; ++k, i = next_[i]) {
            if (is_ear_[i]) return i;
            const double t = turn(i);
            const double rank = t > 0.0 ? 2.0 : (t == 0.0 ? 1.0 : 0.0);
            if (rank > best) {
                best = rank;
                fallback = i;
            }
        }
        return fallback;
    }

    const std::vector<Point2>& p_;
    std::vector<std::size_t> next_, previous_;
    std::vector<char> is_reflex_, is_ear_;
};

}  // namespace

bool triangulate_polygon(std::span<const std::uint32_t> indices, std::span<const Vertex> vertices,
                         Buffer<Triangle>& triangles, ConcaveBudget& budget)
{
    const std::size_t n = indices.size();
    const auto emit = [&](std::size_t a, std::size_t b, std::size_t c) {
        triangles.push_back({indices[a], indices[b], indices[c]});
    };
    if (n == 3) {
        emit(0, 1, 2);
        return true;
    }
    const std::vector<Point2> points = project(indices, vertices);
    if (is_convex(points)) {
        for (std::size_t i = 2; i < n; ++i) emit(0, i - 1, i);
        return true;
    }
    if (!budget.spend(n)) return false;
    EarClipper(points).run(emit);
    return true;
}

}  // namespace kerf::core::io
