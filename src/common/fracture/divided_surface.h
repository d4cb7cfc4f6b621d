#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <map>
#include <span>
#include <vector>

#include "common/fracture/cell_diagram.h"

// A surface divided by the cells that its parts lie in.

namespace kerf::core {

/// Numbers of points: those of the mesh, and behind them those that are new.
using PointTriple = std::array<std::uint32_t, 3>;

/// A triangle of the surface, or a part of one.
struct PartTriangle
{
    PointTriple corners;       ///< counter-clockwise, seen from outside
    std::uint32_t source = 0;  ///< the triangle of the mesh that it lies in
};

/// From a point to another one.
struct PointStep
{
    std::uint32_t from = 0, to = 0;
};

/// Where an edge of the diagram goes through the surface.
struct Piercing
{
    std::uint32_t point = 0;
    bool leaves = false;  ///< the solid, if it is followed along the edge's direction
};

/// Where on the mesh a new point lies: shares of the corners of a triangle, or of the ends of an edge.
struct SurfacePlace
{
    static constexpr std::uint32_t kNoPoint = 0xFFFFFFFFu;

    PointTriple corners{kNoPoint, kNoPoint, kNoPoint};  ///< points of the mesh; of an edge only two
    std::array<double, 3> shares{};                     ///< of them; their sum is 1
};

struct DividedSurface
{
    std::vector<glm::vec3> new_points;
    std::vector<SurfacePlace> places;              ///< of the new points; those that come later do not lie on the mesh
    std::vector<std::vector<PartTriangle>> parts;  ///< of each cell; their sources ascend
    /// Where the surface of one cell borders on that of another, as the cap of the first one runs, seen from the second.
    std::map<SitePair, std::vector<PointStep>> borders;
    std::map<SiteTriple, std::vector<Piercing>> piercings;
    std::uint64_t crossing_triangles = 0;  ///< that lie in several cells
};

/// Divides a closed surface. Which cell a place of it lies in is decided by squared distances from the sites, which are
/// rounded at the points of the mesh and linear between them: so triangles that have an edge in common divide it alike,
/// and all signs are exact. Of two sites that are equally near, the first counts. A new point is rounded once. Nothing depends on the order
/// of the triangles, nor on where their corners begin, but for the order of what comes out.
///
/// Triangles that lie in one cell with all that surrounds them may be left out.
///
/// A triangle whose corners lie in one cell lies in it as a whole, because cells are convex. O(n) for n triangles, and
/// O(c d) for each of k others that lies in c cells with d neighbours.
///
/// @throws Cancelled  `progress` says to stop; so do all functions of this folder that are given one
DividedSurface divide_surface(std::span<const glm::vec3> points, std::span<const PointTriple> triangles,
                              const CellDiagram& diagram, const ProgressOfStep& progress = {});

}  // namespace kerf::core
