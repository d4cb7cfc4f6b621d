#pragma once

#include <array>
#include <vector>

#include "halfedge/components.h"
#include "halfedge/cut_plan.h"

namespace kerf::halfedge {

/// Which fragment everything goes to.
struct PiecePlan
{
    std::array<Index, 2> fragment_count{};             ///< by side
    std::array<std::vector<Index>, 2> whole_fragment;  ///< of each shell that is not cut
};

/// One fragment a side: one bundle for each side of each solid that is cut.
PiecePlan plan_sides(const std::array<std::vector<Shell>, 2>& whole, CutScratch& scratch);

/// One fragment for each connected piece, as kerf::group_pieces() decides; targets must have been separated. The caps
/// of a solid are divided among its pieces by what they are linked to.
PiecePlan plan_pieces(const Universe& universe, const Plane& plane, const std::array<std::vector<Shell>, 2>& whole,
                      const Components& components, CutScratch& scratch);

}  // namespace kerf::halfedge
