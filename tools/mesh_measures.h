#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "tools/flat_mesh.h"

// What a comparison reads off a mesh, triangle by triangle. None of it is the library's: it judges the library.

namespace kerf::tools {

/// Signed volume, summed over the centre of the bounds; mesh units cubed. O(n).
double volume_of(const FlatMesh& mesh);

/// Area of all triangles, caps included; mesh units squared. O(n).
double area_of(const FlatMesh& mesh);

/// Triangles with two corners in one place. O(n).
std::uint64_t degenerate_triangles(const FlatMesh& mesh);

/// Vertices that no file can hold and no cut takes: with a coordinate, a normal or a uv that is not finite. O(n).
std::uint64_t vertices_without_number(const FlatMesh& mesh);

/// Area, in the plane, of the caps with this material, each triangle counted positive; mesh units squared. O(n).
double cap_area_of(const FlatMesh& mesh, std::uint32_t material, const glm::dvec3& normal);

/// How far the mesh reaches beyond the plane to the other side, mesh units; `sign` is that of its own side. O(n).
double overhang_of(const FlatMesh& mesh, const Plane& plane, double sign);

}  // namespace kerf::tools
