#pragma once

#include <cmath>
#include <glm/vec2.hpp>

#include "common/mesh/float_rules.h"

// The exact sign of a turn: on which side of a directed line a point of the plane lies.

namespace kerf::core {

/// turn() for points at which rounding could decide its sign.
double turn_by_expansion(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

/// Twice the signed area of the triangle a, b, c, in squared units of its coordinates: positive if it runs
/// counter-clockwise. The sign is exact, and 0 means collinear; the size is rounded.
///
/// Coordinates must be multiples of 2^-500 below 2^500: then neither a product of two nor its rounding error over- or
/// underflows. Floats are multiples of 2^-149 below 2^128.
///
/// A floating-point filter decides nearly all cases, exact arithmetic the others, at some hundred times the cost:
/// Shewchuk 1997, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", section 4.2.
inline double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    /// Share of the sum of both products by which rounding changes their difference at most.
    constexpr double kHalfUnit = 0x1p-53, kRounding = (3.0 + 16.0 * kHalfUnit) * kHalfUnit;
    const double left = (b.x - a.x) * (c.y - b.y), right = (b.y - a.y) * (c.x - b.x), area = left - right;
    // If both products are 0, each has a factor that is exactly 0.
    if (std::abs(area) >= kRounding * (std::abs(left) + std::abs(right))) return area;
    return turn_by_expansion(a, b, c);
}

}  // namespace kerf::core
