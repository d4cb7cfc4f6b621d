#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "common/repair/linked_surface.h"

// Normals for meshes that have none.

namespace kerf::core {

/// Normals for the corners of a surface; corners of one sector share theirs.
struct SmoothNormals
{
    Buffer<std::uint32_t> sector;  ///< for each corner: a run of triangles around a point without a crease inside
    Buffer<glm::vec3> normals;     ///< for each sector, unit length
};

/// The normal of a sector is the sum of its triangles' normals, weighted by their angles at the point, so that it does
/// not depend on how flat faces are divided into triangles (Thuermer and Wuethrich, "Computing vertex normals from
/// polygonal facets", 1998). Edges that turn by more than `crease_degrees`, 0 to 180, are creases. O(n).
SmoothNormals smooth_normals(const LinkedSurface& surface, std::span<const glm::vec3> positions, double crease_degrees);

}  // namespace kerf::core
