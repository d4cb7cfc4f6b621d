#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/indexed_mesh.h"

namespace kerf {

/// A convex polyhedron whose corners are some of the input points.
struct ConvexHull
{
    std::vector<std::uint32_t> corners;  ///< indices of input points, each once
    std::vector<Triangle> faces;         ///< index into `corners`, counter-clockwise seen from outside; empty when flat
};

/// Convex hull of points; degenerate sets (one point, collinear, coplanar) give their extreme points and no faces.
/// Method: Preparata and Hong 1977 on coordinates quantised to integers, as in Bullet's btConvexHullComputer.
/// O(n log n).
ConvexHull convex_hull(std::span<const glm::vec3> points);

}  // namespace kerf
