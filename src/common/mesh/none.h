#pragma once

#include <cstdint>
#include <limits>

namespace kerf {

/// Stands where there is no vertex, point, triangle, or what else has a number.
inline constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace kerf
