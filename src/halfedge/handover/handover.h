#pragma once

#include <span>
#include <vector>

#include "common/cutting/breakable.h"
#include "halfedge/handover/border.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// Makes trees of pieces: each has the subtrees that were set aside of its cell, where they were, and new leaves of what it
/// has of the border, and its caps. The shells that the border was made of are spent. O(b + c) for b triangles of the border
/// and c new ones. May throw std::bad_alloc, and nothing is spent then.
///
/// @param cap_material  of the universe
/// @return  a shell for each piece
std::vector<ShellRoot> hand_over(Universe& universe, std::span<const ShellRoot> shells, const Border& border,
                                 std::span<const PieceBorder> pieces, std::uint32_t cap_material);

}  // namespace kerf::core::halfedge
