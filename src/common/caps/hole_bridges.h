#pragma once

#include <cstdint>
#include <vector>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Closed rings of corners, one behind the other.
struct Rings
{
    /// Of the outline; a point is there once for each bridge that ends at it, and once more.
    std::vector<Index> points;
    std::vector<CapLink> links;  ///< the edge that leaves each: of the outline, or bridge_link()
    std::vector<Index> starts;   ///< first corner of each ring, and their number at the end
    std::size_t bridge_count = 0;
    std::vector<Index> shared;  ///< points as in CapMesh::shared_points, where loops touch
};

/// One of the two edges of a bridge, which are to be joined once both have a triangle. Numbered behind the outline's.
inline CapLink bridge_link(const CapOutline& outline, std::size_t bridge, std::size_t side)
{
    return CapLink::to_outline(static_cast<Index>(outline.points.size() + 2 * bridge + side));
}

/// Joins the triangles on both sides of each bridge, once all rings are divided into triangles. O(triangles).
void join_bridges(const CapOutline& outline, const Rings& rings, CapMesh& cap);

/// Makes one ring of each outer loop and its holes. Loops that touch in points are parted or joined there. From the leftmost point of each hole a bridge leads to a point on the
/// left that it sees, forth and back (Eberly, "Triangulation by Ear Clipping", section 5). False if a hole has nothing on
/// its left, or after `most_looks`, which is counted down. O(k log k) for few holes side by side.
bool bridge_holes(const CapOutline& outline, Rings& rings, std::uint64_t& most_looks);

}  // namespace kerf::core
