#pragma once

#include <kerf/object.h>

#include <glm/vec3.hpp>
#include <optional>

namespace kerf::sim {

/// A half line, mesh coordinates.
struct MeshRay
{
    glm::dvec3 from{0.0};
    glm::dvec3 along{0.0};  ///< of any length but 0
};

/// Where a ray meets an object's surface first; nothing if it goes past. By Möller and Trumbore ("Fast, Minimum Storage
/// Ray/Triangle Intersection", 1997); a ray through an edge may slip between two triangles, then it meets what lies behind.
/// O(n).
/// @throws std::bad_alloc
std::optional<glm::dvec3> first_hit(const Object& object, const MeshRay& ray);

}  // namespace kerf::sim
