#pragma once

#include <cstdint>
#include <limits>

namespace kerf::core {

/// The number of a vertex, a point, a triangle or the like, counted from 0.
using Index = std::uint32_t;

/// Stands for no vertex, no point, no triangle: for nothing that an Index numbers.
inline constexpr Index kNone = std::numeric_limits<Index>::max();

}  // namespace kerf::core
