#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/mesh/indexed_mesh.h"

namespace kerf::core {

/// A convex polyhedron whose corners are some of the input points.
struct ConvexHull
{
    std::vector<std::uint32_t> corners;  ///< indices of input points, each once, at different positions
    std::vector<Triangle> faces;         ///< index into `corners`, counter-clockwise seen from outside; empty if flat
};

/// Along each axis the hull is computed on a lattice that divides the points' extent into so many steps. A point can
/// stand out of the hull by about one step, and a set thinner than a few steps counts as flat.
inline constexpr double kHullLattice = 10216.0;

/// Convex hull of the finite points. A flat set (no points, one, collinear, coplanar) gives its extreme points, in
/// order around it, and no faces. Points scaled by a power of two give the same hull. O(n log n).
///
/// Method: Preparata and Hong, "Convex hulls of finite sets of points in two and three dimensions", 1977, exact on the
/// lattice, as in Bullet's btConvexHullComputer; flat sets by Andrew's monotone chain, 1979.
ConvexHull convex_hull(std::span<const glm::vec3> points);

}  // namespace kerf::core
