#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/fracture/split_into_cells.h"

namespace kerf::core {

/// A triangle of a contact, as it runs on one of the cells.
struct InsideFacet
{
    PointTriple corners{};
    std::uint32_t contact = 0;
    bool is_turned = false;  ///< on the second cell
};

/// A connected part of a solid that was taken apart: of a cell, or of several that were joined.
struct Fragment
{
    std::vector<std::uint32_t> cells;   ///< ascending
    std::vector<PartTriangle> surface;  ///< their sources ascend
    std::vector<InsideFacet> inside;
    double volume = 0.0;  ///< cubed units of the mesh
};

/// What two fragments have in common: triangles of one contact or more, which close both.
struct Bond
{
    std::uint32_t first = 0, second = 0;  ///< fragments, the smaller number first
    double area = 0.0;                    ///< squared units of the mesh
    glm::dvec3 centre{0.0};
    glm::dvec3 normal{0.0};  ///< from the first to the second, of length 1; 0 if it points nowhere
};

struct Fragments
{
    std::vector<Fragment> fragments;  ///< in the order of their first cells
    std::vector<Bond> bonds;          ///< ascending by fragments
};

/// A cell of which parts of the surface are missing, but which is known to be one fragment.
struct KnownCell
{
    std::uint32_t cell = 0;
    double volume = 0.0;  ///< below what is missing; cubed units of the mesh
};

/// Divides each cell into its connected parts, with the cavities in them, and joins each part of less than `least_volume`
/// to the largest of its neighbours, again and again, until none is left that has a neighbour. A triangle of a contact
/// between parts that are joined is gone. O(n + k log k) for n triangles, k of them at contacts.
///
/// @param points  of the mesh
/// @param split   its parts of the surface go to the fragments; the rest stays
/// @param middle  the point that volumes are summed about: the closer, the more precise
/// @param known   ascending; their fragments have the parts that are there
Fragments find_fragments(std::span<const glm::vec3> points, SplitSolid& split, double least_volume,
                         const glm::dvec3& middle, std::span<const KnownCell> known = {});

}  // namespace kerf::core
