#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/mesh/float_rules.h"

// What is special at the end of the range of float: coordinates may be as large as the largest one.

namespace kerf {

/// The float nearest to `value`, of finite ones: what is beyond the largest becomes the largest, and stays a number
/// that can be stored, written and cut. NaN stays NaN.
inline float nearest_finite_float(double value)
{
    // A cast of what does not fit is undefined in C++.
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value, -kLargest, kLargest));
}

/// The distance from `value` to the next larger float, a unit in its last place; at the largest finite float, which has
/// no neighbour above, the distance to the one below, which is as far.
inline double unit_in_last_place(float value)
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const float above = std::nextafter(value, kInfinity);
    if (std::isinf(above)) return double(value) - double(std::nextafter(value, 0.0f));
    return double(above) - double(value);
}

}  // namespace kerf
