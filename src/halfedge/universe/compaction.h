#pragma once

#include <span>

#include "halfedge/universe/universe.h"

namespace kerf::halfedge {

/// Fills an empty universe with some shells of another one, and returns them there: only what they use, in the order in
/// which export_mesh() visits it; trees in the same order, so that the export of the copy and of all that is cut from
/// it has the same bytes, but with full leaves; room reserved for cuts. Nothing is sorted or searched. O(n) for n
/// triangles of the shells, and memory of the size of the old universe for the moment unless the shells are a small
/// part of it.
std::vector<ShellRoot> compact_copy(const Universe& universe, std::span<const ShellRoot> shells, Universe& copy);

}  // namespace kerf::halfedge
