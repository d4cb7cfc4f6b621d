#pragma once

#include <cstdint>
#include <limits>

namespace kerf {

/// A number of something, counted from 0.
using Index = std::uint32_t;

/// Stands where there is no vertex, point, triangle, or what else has a number.
inline constexpr Index kNone = std::numeric_limits<Index>::max();

}  // namespace kerf
