#pragma once

#include <span>

#include "common/mesh/buffer.h"
#include "common/mesh/index.h"

namespace kerf::core {

/// The neighbours in a mesh that is repaired, or proven: a table. linked_surface.h finds out who they are. Half-edge 3
/// * triangle + corner runs from that corner's point to the next one's.
struct Adjacency
{
    Buffer<Index> opposite;  ///< for each half-edge the one along the same points the other way; kNone at the boundary
    Buffer<Index> shell;     ///< for each triangle; shells are numbered in the order of their first triangles
    Index shell_count = 0;
};

/// Numbers the shells: triangles connected by edges. Fills `shell` and returns the number of shells.
/// O(n log n) at most, O(n) in practice: union-find with path halving.
Index label_shells(std::span<const Index> opposite, Buffer<Index>& shell);

/// The neighbours after a reordering: triangle i is the old triangle order[i]. Shells, which come in the order of their
/// first triangles, are numbered anew. O(n).
Adjacency adjacency_in_order(Buffer<Index> opposite, Buffer<Index> shell, std::span<const Index> order);

}  // namespace kerf::core
