#pragma once

#include <optional>
#include <span>

#include "common/fracture/contacts.h"

namespace kerf::core {

/// A closed surface and what it bounds, taken apart.
struct SplitSolid
{
    std::vector<glm::vec3> new_points;             ///< behind those of the mesh
    std::vector<SurfacePlace> places;              ///< of the first new points: those that lie on the mesh
    std::vector<std::vector<PartTriangle>> parts;  ///< of the surface, for each site; their sources ascend
    std::vector<Contact> contacts;                 ///< ascending by cells
    std::uint64_t crossing_triangles = 0;          ///< that lie in several cells
};

/// Takes the solid that a closed surface bounds apart into the cells of sites: each place belongs to the nearest one. The
/// parts of the surface and the contacts of a cell close it, with the contacts of which it is the second cell turned over.
/// Where the diagram meets an edge or a triangle of the mesh is one rounded point for all cells, and each contact is closed
/// once. The same input gives the same bytes.
///
/// O(n + k log k) for n triangles and k edges and triangles at the borders of cells. Nothing if sites lie so (on a grid, on a
/// sphere) that doubles do not tell which cells meet: then some have to move a little. Nothing, either, if an edge of the
/// diagram goes where the surface passes through itself.
std::optional<SplitSolid> split_into_cells(std::span<const glm::vec3> points, std::span<const PointTriple> triangles,
                                           std::span<const glm::dvec3> sites, const ProgressOfStep& progress = {});

/// The same with a diagram that is there already, and of a surface of which triangles may be missing: those that lie in one
/// cell with all that surrounds them.
std::optional<SplitSolid> split_into_cells(std::span<const glm::vec3> points, std::span<const PointTriple> triangles,
                                           const CellDiagram& diagram, const ProgressOfStep& progress = {});

}  // namespace kerf::core
