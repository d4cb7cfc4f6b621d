#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <vector>

#include "common/cutting/progress.h"
#include "common/mesh/box.h"

// Cells of points in space: the Voronoi diagram, as far as a mesh within a box needs it.

namespace kerf::core {

/// Sites in ascending order.
using SitePair = std::array<std::uint32_t, 2>;
using SiteTriple = std::array<std::uint32_t, 3>;
using SiteQuadruple = std::array<std::uint32_t, 4>;

/// Where four cells meet.
struct DiagramCorner
{
    SiteQuadruple sites;
    glm::dvec3 position;
};

/// Where three cells meet: a part of a line, along the cross product of the second and the third site's directions from
/// the first one. Seen against it, the cells turn counter-clockwise.
struct DiagramEdge
{
    static constexpr std::uint32_t kFarAway = 0xFFFFFFFFu;  ///< no corner: the edge goes on outside of the box

    SiteTriple sites;
    glm::dvec3 direction;                          ///< of any length
    std::uint32_t from = kFarAway, to = kFarAway;  ///< numbers of corners
};

struct CellDiagram
{
    std::vector<glm::dvec3> sites;
    /// For each site those that may have a face in common with it within the box, ascending.
    std::vector<std::vector<std::uint32_t>> neighbours;
    std::vector<DiagramCorner> corners;  ///< ascending by sites
    std::vector<DiagramEdge> edges;      ///< ascending by sites
};

/// The diagram around `bounds`: cells are cut off a little outside. Each cell is cut out of a box by the planes half way to
/// other sites, the nearest first, until those left are farther away than twice its radius (Rycroft, "Voro++", Chaos
/// 19, 2009, section II). O(m^2 log m) for m sites. Nothing if more than four cells meet in a corner, as far as doubles
/// tell: then some sites have to move a little.
std::optional<CellDiagram> make_cell_diagram(std::span<const glm::dvec3> sites, const Box& bounds,
                                             const ProgressOfStep& progress = {});

}  // namespace kerf::core
