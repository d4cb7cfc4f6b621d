#pragma once

#include <cstddef>

#include "halfedge/universe/universe.h"

// Room for cuts to come, so that a cut need not wait for memory.

namespace kerf::core::halfedge {

/// Sizes of a universe's arrays. In a new universe each triangle is one face and one slot.
struct UniverseSize
{
    std::size_t points = 0, edges = 0, triangles = 0, vertices = 0, nodes = 0;
};

/// The crossing triangles of one cut through the middle of a surface, some 3 sqrt(n), with some to spare: what a new
/// universe has room for, and planning. A cut that finds no room left makes some, which costs O(k); so more in advance
/// would serve only objects that are cut again and again, and burden all.
std::size_t crossings_of_one_cut(std::size_t triangles);

/// Makes room in all arrays of an empty universe, but for the tree, for `size` and, by an estimate, for cuts that cross `crossings`
/// triangles in all. Touches the room for cuts; the caller is about to write the rest. The half-edge mesh is empty still,
/// and none of its room is touched. Throws std::bad_alloc.
void reserve(Universe& universe, const UniverseSize& size, std::size_t crossings);
/// The same for the tree. Throws std::bad_alloc.
void reserve_nodes(Universe& universe, const UniverseSize& size, std::size_t crossings);

}  // namespace kerf::core::halfedge
