#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

#include "common/mesh/indexed_mesh.h"

namespace kerf::core::test {

using Polygon = std::vector<glm::dvec2>;

/// A prism over any polygon, from y = -1 to y = 1: it runs through itself where the polygon crosses itself.
IndexedMesh prism_over(const Polygon& polygon);

/// The star polygon {points / turns}, which winds around its middle that many times.
Polygon star(std::uint32_t points, std::uint32_t turns);

}  // namespace kerf::core::test
