#pragma once

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Up to so many triangles a cap is made Delaunay by flips: those of low-poly models, in which a sliver is a large share of
/// what a later cut meets. A larger section costs more than the slivers that its layers leave.
inline constexpr std::size_t kMostFlippedTriangles = 30;

/// Flips the edge between two triangles where that makes their smallest angle larger, until there is none: the triangles
/// are then the Delaunay triangulation of the outline's inside, apart from rounding (Lawson 1977, "Software for C1 surface
/// interpolation", section 4). So points along a straight side share no triangle, in which a later cut would find points
/// that fall together.
///
/// Triangles run counter-clockwise before and after; flat ones are flipped away where that is possible. Edges are links to
/// triangles or to the outline, and stay so. There are at most kMostFlippedTriangles. O(t + f) for t triangles and f flips.
void flip_edges(std::span<const glm::dvec2> points, std::vector<CapTriangle>& triangles);

}  // namespace kerf::core
