#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "maker/poly_mesh.h"

namespace kerf::maker {

/// The nearest number that files hold: decimals of 1e-5, short in a text, and the last bits of a sine, which may
/// differ from one C library to the next, stay out of them. Never -0.
double rounded(double x);

/// The mesh with its points rounded: what normals are to be taken from.
PolyMesh with_rounded_points(PolyMesh mesh);

/// Texture coordinate by projection along the axis that the facet faces most: one unit of texture a unit of length.
glm::dvec2 box_uv(const glm::dvec3& p, const glm::dvec3& normal);

/// For each facet and corner the shading normal: the facet's own, or for a smoothing group the mean over the group's
/// facets at that point, weighted by area.
std::vector<std::vector<glm::dvec3>> corner_normals(const PolyMesh& mesh);

}  // namespace kerf::maker
