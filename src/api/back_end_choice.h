#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "common/mesh/indexed_mesh.h"

namespace kerf {

/// Whether so many cuts pay the half-edge back end's preparing back, with all that a game needs of the pieces: meshes,
/// masses, hulls, views. O(1): of a large mesh it looks at some triangles.
bool preparing_pays(const core::IndexedMesh& mesh, std::uint32_t cuts);

/// The same of one stack of sections across a normal of unit length. O(h log h) for h heights. May throw std::bad_alloc.
bool preparing_pays(const core::IndexedMesh& mesh, const glm::dvec3& normal, std::span<const double> heights);

}  // namespace kerf
