#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>

namespace kerf::core {

/// Number of directions of the bounded hull, hence the bound on its points.
inline constexpr std::size_t kSupportDirections = 32;

/// The fixed unit directions of the bounded hull: sixteen lines, then the same lines in the opposite direction, bit for
/// bit the negatives (i and i + 16 belong together). The first three are the axes. No direction in space is farther
/// than 24.6 degrees from one of them.
const std::array<glm::vec3, kSupportDirections>& support_directions();

}  // namespace kerf::core
