#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/mesh/float_rules.h"

// Arithmetic at the end of the range of float: coordinates may be as large as the largest float.

namespace kerf::core {

/// The finite float nearest to `value`: a value beyond the largest float becomes the largest float, which can be
/// stored, written and cut. NaN stays NaN.
inline float nearest_finite_float(double value)
{
    // In C++ the cast of a value that does not fit is undefined.
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

/// The distance from `value` to the next larger float: a unit in its last place. The largest finite float has no
/// neighbour above; the distance to the one below is the same.
inline double unit_in_last_place(float value)
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const float above = std::nextafter(value, kInfinity);
    if (std::isinf(above)) return double(value) - double(std::nextafter(value, 0.0f));
    return double(above) - double(value);
}

}  // namespace kerf::core
