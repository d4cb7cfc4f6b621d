#include "common/cutting/cut_geometry.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace kerf::core {

namespace {

double squared_distance(const glm::vec3& a, const glm::vec3& b)
{
    const double x = double(b.x) - double(a.x), y = double(b.y) - double(a.y), z = double(b.z) - double(a.z);
    return (x * x + y * y) + z * z;
}

float between(double value, float a, float b)
{
    const double lo = std::min(a, b), hi = std::max(a, b);
    // + 0.0f turns -0 into +0, so that equal positions have equal bits.
    return static_cast<float>(std::clamp(value, lo, hi)) + 0.0f;
}

}  // namespace

Side coplanar_side(const Plane& plane, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
    // The rounding of the cross product depends on the corner it starts from: always start from the same one.
    std::array<const glm::vec3*, 3> p{&a, &b, &c};
    const auto first = std::min_element(p.begin(), p.end(),
                                        [](const auto* s, const auto* t) { return lexicographically_less(*s, *t); });
    std::rotate(p.begin(), first, p.end());
    const glm::dvec3 e = glm::dvec3(*p[1]) - glm::dvec3(*p[0]), f = glm::dvec3(*p[2]) - glm::dvec3(*p[0]);
    const glm::dvec3 n{e.y * f.z - e.z * f.y, e.z * f.x - e.x * f.z, e.x * f.y - e.y * f.x};
    const double along = (plane.normal.x * n.x + plane.normal.y * n.y) + plane.normal.z * n.z;
    if (along != 0.0) return along > 0.0 ? Side::negative : Side::positive;
    // A needle has no back. It goes to the side of larger x (or y, or z), whichever way the plane's normal points.
    const double leading =
        plane.normal.x != 0.0 ? plane.normal.x : (plane.normal.y != 0.0 ? plane.normal.y : plane.normal.z);
    return leading > 0.0 ? Side::positive : Side::negative;
}

CutPoint cut_edge(const glm::vec3& a, double da, const glm::vec3& b, double db)
{
    CutPoint point;
    point.swapped = lexicographically_less(b, a);
    const glm::vec3& lo = point.swapped ? b : a;
    const glm::vec3& hi = point.swapped ? a : b;
    const double dlo = point.swapped ? db : da;
    const double dhi = point.swapped ? da : db;
    if (dlo == 0.0) {
        point.t = 0.0;
        point.position = lo;
        return point;
    }
    if (dhi == 0.0) {
        point.t = 1.0;
        point.position = hi;
        return point;
    }
    point.t = dlo / (dlo - dhi);
    const auto coordinate = [&](float s, float e) {
        return between(double(s) + point.t * (double(e) - double(s)), s, e);
    };
    point.position = {coordinate(lo.x, hi.x), coordinate(lo.y, hi.y), coordinate(lo.z, hi.z)};
    return point;
}

Vertex interpolate(const CutPoint& point, const Vertex& a, const Vertex& b)
{
    const Vertex& lo = point.swapped ? b : a;
    const Vertex& hi = point.swapped ? a : b;
    const double t = point.t;
    const auto mix = [t](float s, float e) { return double(s) + t * (double(e) - double(s)); };

    Vertex v;
    v.position = point.position;
    const glm::dvec3 n{mix(lo.normal.x, hi.normal.x), mix(lo.normal.y, hi.normal.y), mix(lo.normal.z, hi.normal.z)};
    const double length = std::sqrt((n.x * n.x + n.y * n.y) + n.z * n.z);
    // Opposite normals can cancel; then one of the two is as good as the other.
    v.normal = length > 0.0 ? glm::vec3(n / length) : lo.normal;
    v.uv = {static_cast<float>(mix(lo.uv.x, hi.uv.x)), static_cast<float>(mix(lo.uv.y, hi.uv.y))};
    return v;
}

void interpolate(const CutPoint& point, const float* a, const float* b, float* result, std::uint32_t width)
{
    const float* lo = point.swapped ? b : a;
    const float* hi = point.swapped ? a : b;
    for (std::uint32_t i = 0; i < width; ++i)
        result[i] = static_cast<float>(double(lo[i]) + point.t * (double(hi[i]) - double(lo[i])));
}

TriangleSplit split_triangle(const std::array<glm::vec3, 3>& p, const std::array<double, 3>& d)
{
    TriangleSplit split;

    // The lone corner is the one whose side the other two do not share.
    const std::array<Side, 3> side{side_of(d[0]), side_of(d[1]), side_of(d[2])};
    split.lone = side[0] == side[1] ? 2 : (side[0] == side[2] ? 1 : 0);
    const std::uint8_t lone = split.lone;
    const auto next = static_cast<std::uint8_t>((lone + 1) % 3), previous = static_cast<std::uint8_t>((lone + 2) % 3);
    split.lone_side = side[lone];

    split.cut_next = cut_edge(p[lone], d[lone], p[next], d[next]);
    split.cut_previous = cut_edge(p[previous], d[previous], p[lone], d[lone]);

    // Coincidences, corners first: an existing vertex wins over a cut point.
    const auto corner_at = [&](const glm::vec3& position, std::uint8_t otherwise) {
        for (const std::uint8_t corner : {lone, next, previous})
            if (same_position(position, p[corner])) return corner;
        return otherwise;
    };
    split.next_code = corner_at(split.cut_next.position, TriangleSplit::kCutNext);
    split.previous_code = corner_at(split.cut_previous.position, TriangleSplit::kCutPrevious);
    if (split.previous_code == TriangleSplit::kCutPrevious && split.next_code == TriangleSplit::kCutNext &&
        same_position(split.cut_next.position, split.cut_previous.position))
        split.previous_code = TriangleSplit::kCutNext;
    const std::uint8_t n = split.next_code, q = split.previous_code;

    const auto add = [&](Side s, std::uint8_t a, std::uint8_t b, std::uint8_t c) {
        if (a != b && b != c && c != a) split.sub_triangle[split.sub_triangle_count++] = {s, {a, b, c}};
    };
    add(split.lone_side, lone, n, q);

    // The quadrilateral N, next, previous, P. If N is `next` (or P is `previous`, or N is P), one of the two triangles
    // below vanishes with either diagonal; if opposite corners coincide, the outline runs forth and back over itself
    // and bounds nothing.
    const Side far_side = opposite(split.lone_side);
    if (n != previous && q != next) {
        const auto position = [&](std::uint8_t code) -> const glm::vec3& {
            if (code == TriangleSplit::kCutNext) return split.cut_next.position;
            if (code == TriangleSplit::kCutPrevious) return split.cut_previous.position;
            return p[code];
        };
        const bool quad = n != next && q != previous && n != q;
        bool from_n = true;  // diagonal N - previous, otherwise next - P
        if (quad) {
            const double dn = squared_distance(position(n), p[previous]), dq = squared_distance(p[next], position(q));
            if (dn != dq) {
                from_n = dn < dq;
            } else {
                const glm::vec3& least_n = std::min(position(n), p[previous], lexicographically_less);
                const glm::vec3& least_q = std::min(p[next], position(q), lexicographically_less);
                from_n = lexicographically_less(least_n, least_q);
            }
        }
        if (from_n) {
            add(far_side, n, next, previous);
            add(far_side, n, previous, q);
        } else {
            add(far_side, n, next, q);
            add(far_side, next, previous, q);
        }
    }

    // The lone triangle holds the directed edge N -> P.
    split.section_from = split.lone_side == Side::positive ? n : q;
    split.section_to = split.lone_side == Side::positive ? q : n;
    return split;
}

}  // namespace kerf::core
