#pragma once

#include <vector>

#include "common/caps/section_closer.h"
#include "common/mesh/side.h"

namespace kerf::core::halfedge {

/// The result of CAP: the triangles that close the section. Their corners are loop points, and outline edges are those
/// of `loop_edges` (section.h).
struct Caps : SectionCaps
{
    std::vector<BySide<Index>> piece_shells;  ///< of each triangle; hand_out_caps() fills it

    void reserve(std::size_t crossings_expected);
    void clear()
    {
        SectionCaps::clear();
        piece_shells.clear();
    }
};

}  // namespace kerf::core::halfedge
