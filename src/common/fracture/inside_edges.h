#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "common/fracture/divided_surface.h"

namespace kerf::core {

/// A part of an edge of the diagram that lies in the solid.
struct InsideEdge
{
    SiteTriple sites;
    PointStep step;  ///< along the edge's direction
};

/// Which parts of the diagram's edges lie in the solid that the surface bounds, and which corners. Corners inside become
/// new points of the surface. Nothing if rounding has left a contradiction, such as an edge that leaves the solid twice in
/// a row: then some sites have to move a little. O(e log e).
///
/// @param points  of the mesh
std::optional<std::vector<InsideEdge>> find_inside_edges(const CellDiagram& diagram, std::span<const glm::vec3> points,
                                                         DividedSurface& surface);

}  // namespace kerf::core
