#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/mesh/indexed_mesh.h"

namespace kerf::core {

/// How to treat a triangle before the search for its neighbours. A repeat has the same three points as an earlier
/// triangle, in the same orientation.
enum class TriangleFault : std::uint8_t
{
    none,
    degenerate,  ///< two corners at one point: drop it; its two other sides cancel
    duplicate,   ///< a repeat that nothing needs: drop it
    coinciding,  ///< a repeat that holds an edge closed: keep it
};

/// Whether a triangle with this fault stays.
inline bool is_kept(TriangleFault fault)
{
    return fault == TriangleFault::none || fault == TriangleFault::coinciding;
}

/// The faults of all triangles.
struct Faults
{
    std::vector<TriangleFault> of;     ///< for each triangle
    Buffer<std::uint8_t> turned_over;  ///< 1 for each that is to be turned over first; empty: none is
    std::uint64_t repeats = 0;         ///< triangles that repeat others before any is turned over

    bool is_turned_over(std::size_t t) const { return !turned_over.empty() && turned_over[t] != 0; }
};

/// Finds the faults of triangles. `corners` holds the three point ids of each triangle, all below `point_count`.
///
/// The balance of an edge is how many more triangles run along it one way than the other; at a closed edge it is 0. The
/// second triangles over the same points make one layer, the third ones the next, and so on; a cluster is
/// a part of a layer connected by edges. Repeats are dropped cluster by cluster, last layers first, and a cluster only
/// if that takes no edge farther from balance: a closed edge stays closed. So a whole shell that occurs twice is dropped once, because
/// that changes no balance, and so is a triangle that occurs once too often, on a closed surface or an open one. The
/// face that two solids have in common, in the same orientation, stays twice.
///
/// Unless triangles are turned over, the number of triangles dropped over the same points depends neither on the order
/// of triangles nor on the numbers of points. The choice among them does, but the first stays. O(n) for bounded
/// valence, O(n log n) otherwise.
///
/// Triangles that face the wrong way upset the balance. If an edge of a repeat has an even number of triangles, of
/// different points, and is not balanced, they are turned back first, as find_turned_sheets() says, and the faults are
/// those of the result. So a surface that is closed but for such triangles keeps what it needs. But if fewer triangles
/// stay open if repeats are dropped first and the rest is turned afterwards, nothing is turned here: a wall at an
/// edge of a repeat, turned over, would close that edge and hold the repeat.
Faults find_faults(std::uint32_t point_count, std::span<const Triangle> corners);

/// What find_faults() finds if every edge has two triangles at most, and these run along it in opposite directions.
Faults no_faults(std::size_t triangle_count);

/// The triangles that stay, turned over where their faults say so.
struct KeptTriangles
{
    Buffer<Triangle> corners;          ///< point ids
    Buffer<std::uint32_t> from;        ///< for each its number before others were dropped
    Buffer<std::uint8_t> turned_over;  ///< 1 for each that was turned over; empty: none was
};

/// Drops triangles, in otherwise unchanged order, and turns others over. O(n).
KeptTriangles keep(Buffer<Triangle> corners, const Faults& faults);

}  // namespace kerf::core
