#pragma once

#include <array>
#include <vector>

#include "halfedge/cut/cut_plan.h"

namespace kerf::halfedge {

/// Which fragment everything goes to.
struct PiecePlan
{
    BySide<Index> fragment_count{};
    BySide<std::vector<Index>> whole_fragment;  ///< of each shell that is not cut
};

/// One fragment a side: one piece shell for each side of each solid that is cut.
PiecePlan plan_sides(const BySide<std::vector<ShellRoot>>& whole, CutScratch& scratch);

/// One fragment for each connected piece, as kerf::group_pieces() decides; targets must have been separated. An
/// irregular outline is linked once more, so that each loop lies between two piece shells.
PiecePlan plan_pieces(const Universe& universe, const Plane& plane, const BySide<std::vector<ShellRoot>>& whole,
                      CutScratch& scratch);

/// Puts loops that lie between the same two piece shells into one set, so that each set can be closed by itself.
void plan_cap_sets(CutScratch& scratch);

/// Hands the caps to the piece shells.
void hand_out_caps(CutScratch& scratch);

/// Divides the piece shells of pieces into what is connected by half-edges, caps included: a piece may have several
/// shells.
void divide_piece_shells(CutScratch& scratch);

}  // namespace kerf::halfedge
