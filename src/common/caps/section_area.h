#pragma once

#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>

#include "common/mesh/box.h"
#include "common/mesh/plane.h"

// Signed area and length of sections, the same in whatever order their edges come.

namespace kerf::core {

/// Adds up numbers below a bound; the sum has the same bits in any order. Numbers are rounded to 2^-90 of the bound and
/// added as integers, so up to 2^36 of them lose no more than a double does for one.
class OrderlessSum
{
public:
    /// `bound` is finite, and no number is larger.
    explicit OrderlessSum(double bound)
    {
        int exponent = 0;
        std::frexp(bound, &exponent);
        unit_ = std::ldexp(1.0, exponent - kBits);
        per_unit_ = std::ldexp(1.0, kBits - exponent);
    }

    void add(double value)
    {
        // In two parts, both exact: at once, the conversion is a call that costs more than all else here.
        const double units = value * per_unit_;
        const auto high = static_cast<std::int64_t>(units * 0x1p-52);
        const auto low = static_cast<std::int64_t>(units - static_cast<double>(high) * 0x1p52);
        sum_ += Integer(high) * (Integer(1) << 52) + low;
    }
    /// Adds what another sum of the same bound holds, as if its numbers were added here.
    void add(const OrderlessSum& other) { sum_ += other.sum_; }
    double value() const { return static_cast<double>(sum_) * unit_; }

private:
    __extension__ using Integer = __int128;
    static constexpr int kBits = 90;

    double unit_, per_unit_;
    Integer sum_ = 0;
};

/// For twice the areas of the triangles between the edges of loops and a corner of the loops' box, which is not empty.
inline OrderlessSum sum_of_twice_areas(const Box& box)
{
    const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    return OrderlessSum(4.0 * glm::dot(size, size));
}

/// Signed area of closed loops in a plane, in mesh units squared: positive if they run counter-clockwise seen from the
/// positive side. The bits do not depend on the order of the edges. `for_each_edge(visit)` calls visit(p, q) for the
/// two ends of each edge of all loops; it is called twice. O(k).
template <class ForEachEdge>
double section_area(const Plane& plane, ForEachEdge for_each_edge)
{
    Box box;
    for_each_edge([&](const glm::vec3& p, const glm::vec3&) { box.add(p); });
    if (box.empty()) return 0.0;
    // About a corner of the box, so that a section far from the origin loses no digits.
    const glm::dvec3 origin(box.lo);
    OrderlessSum twice = sum_of_twice_areas(box);
    for_each_edge([&](const glm::vec3& p, const glm::vec3& q) {
        twice.add(glm::dot(plane.normal, glm::cross(glm::dvec3(p) - origin, glm::dvec3(q) - origin)));
    });
    return 0.5 * twice.value();
}

}  // namespace kerf::core
