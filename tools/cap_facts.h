#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "tools/flat_mesh.h"

namespace kerf::tools {

/// The triangles of one cap in the coordinates of its plane, seen from the plane's positive side: a triangle that faces
/// +normal runs counter-clockwise.
struct FlatCap
{
    std::vector<glm::dvec2> points;
    std::vector<Triangle> triangles;
};

/// The triangles of `mesh` that are cap and have this material, laid into the plane with this unit normal. O(n).
FlatCap flat_cap(const FlatMesh& mesh, std::uint32_t material, const glm::dvec3& normal);

/// The closed loops in the same coordinates.
std::vector<std::vector<glm::dvec2>> flat_loops(std::span<const Outline> loops, const glm::dvec3& normal);

/// Sum of the triangles' areas, each counted positive; mesh units squared.
double unsigned_area(const FlatCap& cap);

/// The smallest angle of all triangles, degrees; 180 for a cap without triangles.
double least_angle(const FlatCap& cap);

/// Caps of more triangles are not searched for overlaps, which costs the square of their number and more.
inline constexpr std::size_t kMostForOverlap = 400;

/// Area that more than one triangle covers, mesh units squared; not a number above kMostForOverlap, or where triangles
/// cross too often to be looked through. Up to the error of
/// rounding corners, along edges.
double overlap_area(const FlatCap& cap);

}  // namespace kerf::tools
