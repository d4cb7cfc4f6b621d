#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/repair/linked_surface.h"

namespace kerf::core {

/// Links the triangles around each of the edges where more than two meet, in pairs that bound the same wedge of solid:
/// they are sorted by their angle and matched like brackets, those of one patch first if wedges overlap. A half-edge
/// without a partner becomes boundary. O(d log d) for d triangles at an edge.
///
/// @param positions  of the points
/// @param patch      of each triangle
void pair_at_edges(LinkedSurface& surface, std::span<const NonmanifoldEdge> edges, std::span<const glm::vec3> positions,
                   std::span<const std::uint32_t> patch);

}  // namespace kerf::core
