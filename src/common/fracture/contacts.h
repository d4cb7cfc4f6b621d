#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "common/fracture/inside_edges.h"

namespace kerf::core {

/// Where two cells touch: a part of the plane half way between their sites.
struct Contact
{
    SitePair cells;
    glm::dvec3 normal{0.0};  ///< from the first to the second, of length 1
    /// What closes the first cell there; turned over, the second one. Counter-clockwise, seen from the second one.
    std::vector<PointTriple> triangles;
};

/// Closes each contact once. Points where outlines cross are new points of the surface. Nothing if an outline is not
/// closed, which rounding may have done: then some sites have to move a little. O(k log k) for k edges of outlines.
///
/// @param points  of the mesh
std::optional<std::vector<Contact>> close_contacts(const CellDiagram& diagram, std::span<const glm::vec3> points,
                                                   std::span<const InsideEdge> edges, DividedSurface& surface,
                                                   const ProgressOfStep& progress = {});

}  // namespace kerf::core
