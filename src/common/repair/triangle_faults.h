#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/indexed_mesh.h"

namespace kerf {

/// What is to be done with a triangle before its neighbours are looked for. A repeat has the same three points as an
/// earlier triangle, in the same orientation.
enum class TriangleFault : std::uint8_t
{
    none,
    degenerate,  ///< two corners in one point: drop it; it runs along its other side forth and back
    duplicate,   ///< a repeat that nothing needs: drop it
    coinciding,  ///< a repeat that holds an edge closed: keep it
};

/// Whether a triangle with this fault stays.
inline bool is_kept(TriangleFault fault)
{
    return fault == TriangleFault::none || fault == TriangleFault::coinciding;
}

/// What is to be done with all of them.
struct Faults
{
    std::vector<TriangleFault> of;     ///< for each triangle
    Buffer<std::uint8_t> turned_over;  ///< 1 for each that is to be turned over first; empty: none is
    std::uint64_t repeats = 0;         ///< triangles that repeat others as they come, before any is turned over

    bool is_turned_over(std::size_t t) const { return !turned_over.empty() && turned_over[t] != 0; }
};

/// Finds the faults of triangles. `corners` holds the three point ids of each triangle, all below `point_count`.
///
/// The balance of an edge is how many more triangles run along it one way than the other; a closed edge has none over.
/// Repeats are dropped patch by patch, and a patch only if no edge gets farther from balance by that: what is closed
/// stays closed. The second triangles over the same points make one layer, the third ones the next, and so on; a patch
/// is what hangs together by edges in one layer; last layers are judged first. So a whole shell that is there twice is
/// dropped once, for that changes no balance, and so is a triangle that is there once too often, on a closed surface or
/// an open one. The face that two solids have in common, in the same orientation, stays twice.
///
/// Unless triangles are turned over, how many over the same points are dropped depends neither on the order of
/// triangles nor on the numbers of points; which ones does, but the first stays. O(n) for bounded valence, O(n log n)
/// otherwise.
///
/// Triangles that are turned over would upset the balance: where an edge of a repeat has an even number of triangles,
/// of different points, and is not balanced, they are turned back first, as find_turned_sheets() says, and faults are
/// those of what that leaves. So what is closed but for triangles that are turned over keeps what it needs. But where
/// fewer triangles stay open if repeats are dropped first and the rest is turned afterwards, nothing is turned here: a
/// wall at an edge of a repeat, turned over, would close that edge and hold the repeat.
Faults find_faults(std::uint32_t point_count, std::span<const Triangle> corners);

}  // namespace kerf
