#pragma once

#include <cmath>
#include <glm/vec3.hpp>

namespace kerf::core {

/// Whether all coordinates are.
template <class Number>
bool is_finite(const glm::vec<3, Number>& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

}  // namespace kerf::core
