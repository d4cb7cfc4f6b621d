#include <kerf/plane.h>

#include <algorithm>
#include <cmath>

#include "api/convert.h"

namespace kerf {

namespace {

double largest(const glm::dvec3& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// From one point to another, or half of that where it is larger than doubles are.
glm::dvec3 direction(const glm::dvec3& from, const glm::dvec3& to)
{
    const glm::dvec3 whole = to - from;
    return std::isfinite(largest(whole)) ? whole : 0.5 * to - 0.5 * from;
}

/// Whether the columns span space, as far as doubles tell, at whatever scale each of them is.
bool span_space(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
{
    // The largest numbers are divided out, so that the product neither overflows nor vanishes. 0 / 0 is no number.
    const glm::dvec3 p = a / largest(a), q = b / largest(b), r = c / largest(c);
    const double volume = glm::dot(p, glm::cross(q, r));
    // Share of the sum of the products by which rounding changes the volume at most: three divisions, two products, and
    // the sums, each by half a unit in the last place.
    constexpr double kRounding = 8.0 * 0x1p-53;
    const glm::dvec3 sizes(std::abs(q.y * r.z) + std::abs(q.z * r.y), std::abs(q.z * r.x) + std::abs(q.x * r.z),
                           std::abs(q.x * r.y) + std::abs(q.y * r.x));
    return std::abs(volume) > kRounding * glm::dot(glm::abs(p), sizes);
}

}  // namespace

std::optional<Plane> Plane::at(Point point, Normal normal) noexcept
{
    const auto found = core::Plane::through(to_core(point), to_core(normal));
    if (!found) return std::nullopt;
    return Plane(Normal(found->normal.x, found->normal.y, found->normal.z), found->offset);
}

std::optional<Plane> Plane::through(Vec3d a, Vec3d b, Vec3d c) noexcept
{
    const glm::dvec3 p = to_core(a), q = to_core(b), r = to_core(c);
    // The largest difference is divided out first, so that the product neither overflows nor vanishes.
    const glm::dvec3 e = direction(p, q), f = direction(p, r);
    const double scale_e = largest(e), scale_f = largest(f);
    if (!(scale_e > 0.0) || !(scale_f > 0.0)) return std::nullopt;
    const glm::dvec3 n = glm::cross(e / scale_e, f / scale_f);
    return at(Point(a.x, a.y, a.z), Normal(n.x, n.y, n.z));
}

std::optional<Plane> Plane::from_coefficients(double a, double b, double c, double d) noexcept
{
    // The smallest numbers have too few digits to divide by: enlarged, which is exact, they have all. The length of the
    // largest is no double; that of their halves is.
    constexpr double kSmall = 0x1p-900, kEnlarge = 0x1p200, kLarge = 0x1p1000, kHalve = 0.5;
    const double most = largest({a, b, c}), scale = most < kSmall ? kEnlarge : most > kLarge ? kHalve : 1.0;
    for (double* number : {&a, &b, &c, &d}) *number *= scale;
    const double length = std::hypot(a, b, c);
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(d / length)) return std::nullopt;
    return Plane(Normal(a / length, b / length, c / length), -d / length);
}

std::optional<Plane> Plane::x(double value) noexcept
{
    return from_coefficients(1.0, 0.0, 0.0, -value);
}

std::optional<Plane> Plane::y(double value) noexcept
{
    return from_coefficients(0.0, 1.0, 0.0, -value);
}

std::optional<Plane> Plane::z(double value) noexcept
{
    return from_coefficients(0.0, 0.0, 1.0, -value);
}

std::optional<Plane> Plane::moved(double distance) const noexcept
{
    const double offset = offset_ + distance;
    if (!std::isfinite(offset)) return std::nullopt;
    return Plane(normal_, offset);
}

Plane Plane::flipped() const noexcept
{
    return Plane(Normal(-normal_.x, -normal_.y, -normal_.z), -offset_);
}

std::optional<Plane> Plane::to_local(const Mat4d& object_to_world) const noexcept
{
    const auto& m = object_to_world.m;
    const double w = m[3][3];
    if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || w == 0.0 || !std::isfinite(w)) return std::nullopt;
    const glm::dvec3 columns[3]{{m[0][0], m[0][1], m[0][2]}, {m[1][0], m[1][1], m[1][2]}, {m[2][0], m[2][1], m[2][2]}};
    if (!span_space(columns[0], columns[1], columns[2])) return std::nullopt;
    // n . (A p + t) / w = offset, so the normal of the object's plane is A^T n, and no inverse is needed.
    const glm::dvec3 n = w > 0.0 ? to_core(normal_) : -to_core(normal_);
    const double moved = n.x * m[3][0] + n.y * m[3][1] + n.z * m[3][2];
    return from_coefficients(glm::dot(columns[0], n), glm::dot(columns[1], n), glm::dot(columns[2], n),
                             moved - offset_ * std::abs(w));
}

double Plane::distance(Vec3d p) const noexcept
{
    return ((normal_.x * p.x + normal_.y * p.y) + normal_.z * p.z) - offset_;
}

}  // namespace kerf
