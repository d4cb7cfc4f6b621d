#pragma once

#include <vector>

#include "common/caps/cap_triangulator.h"
#include "common/mesh/side.h"

namespace kerf::halfedge {

/// The caps of one set of loops.
struct CapSet
{
    Index set = 0;
    std::size_t first = 0, count = 0;  ///< triangles
};

/// The result of CAP: the triangles that close the section, each for both sides.
struct Caps
{
    /// Corners are loop points, counter-clockwise seen from the positive side; outline edges are those of `loop_edges`.
    std::vector<CapTriangle> triangles;
    std::vector<CapSet> sets;
    std::vector<Index> order;                 ///< of the triangles, spatially coherent within a set
    std::vector<BySide<Index>> piece_shells;  ///< of each triangle; hand_out_caps() fills it

    void reserve(std::size_t crossings_expected);
    void clear()
    {
        triangles.clear();
        sets.clear();
        order.clear();
        piece_shells.clear();
    }
};

}  // namespace kerf::halfedge
