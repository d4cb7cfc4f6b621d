#pragma once

#include <span>

#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// Copies some shells of a universe into an empty one and returns them there. The copy holds only what they use, in the
/// order in which export_mesh() visits it. Its trees have the same order, so the export of the copy and of all
/// fragments cut from it has the same bytes, but their leaves are full. Room is reserved for cuts. Nothing is sorted or
/// searched. O(n) for n triangles of the shells, and for the moment memory of the size of the old universe unless the
/// shells are a small part of it.
std::vector<ShellRoot> compact_copy(const Universe& universe, std::span<const ShellRoot> shells, Universe& copy);

}  // namespace kerf::core::halfedge
