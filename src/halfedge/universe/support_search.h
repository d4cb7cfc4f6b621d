#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "halfedge/universe/triangle_tree.h"

namespace kerf::core::halfedge {

/// For each support direction the extreme vertex under `roots`, as core::support_points() defines it. Goes down only
/// where a node's support value is that of the roots: O(log n) for each direction on ordinary shapes.
std::array<glm::vec3, kSupportDirections> support_points(const TriangleTree& tree, const TreeGeometry& geometry,
                                                         std::span<const NodeId> roots);

}  // namespace kerf::core::halfedge
