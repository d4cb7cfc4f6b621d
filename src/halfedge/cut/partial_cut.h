#pragma once

#include <vector>

#include "common/cutting/cut.h"
#include "halfedge/cut/planned_pieces.h"
#include "halfedge/cut/section.h"

// CutOptions::only: a cut along some of the outline. The outline and the pieces of the whole cut are found first, which
// changes nothing; then what the chosen paths do not part is put together again.

namespace kerf::core::halfedge {

/// Whether each outline edge lies in a path that `only` means, by number. O(k log k).
std::vector<bool> chosen_edges(const Universe& universe, const Plane& plane, const OnlyNear& only, const Found& found,
                               const Section& section);

/// Makes of what a whole cut has found, once its pieces are planned, what a cut along the chosen edges finds: all other
/// crossing triangles are kept as they are, subtrees that are not taken apart any more are handed over whole, and
/// `pieces` says where everything goes. Numbers of crossing triangles and of outline edges are new, so that SPLIT and WALK
/// must follow. Returns false, and leaves both useless, if the chosen edges do not part the object (JoinedPieces).
/// O(k + leaves that are open). May throw std::bad_alloc.
///
/// @param shells            of the object
/// @param split_components  a fragment for each piece; otherwise one a side
bool keep_the_rest_whole(const Universe& universe, const std::vector<ShellRoot>& shells,
                         const std::vector<bool>& is_chosen, bool split_components, Found& found, Pieces& pieces);

}  // namespace kerf::core::halfedge
