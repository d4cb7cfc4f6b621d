#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

namespace kerf::maker {

/// Constrained Delaunay triangulation of a simple counter-clockwise polygon with points inside it. Corners are numbered
/// first, then the inner points; triangles are counter-clockwise. By insertion and edge flips (Lawson 1977); no edge of
/// the polygon is flipped. O(n^2) and worse: for outlines drawn by hand. Throws std::logic_error when a point does not
/// lie inside.
std::vector<std::array<int, 3>> delaunay(const std::vector<glm::dvec2>& polygon, const std::vector<glm::dvec2>& inside);

}  // namespace kerf::maker
