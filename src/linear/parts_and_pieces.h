#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/cutting/group_pieces.h"
#include "linear/fragment.h"
#include "linear/section.h"
#include "linear/side_builder.h"

namespace kerf::core::linear {

/// One side before its cap, flooded over its edges.
struct FoundParts
{
    std::vector<std::uint32_t> part_of_triangle;
    std::vector<std::uint32_t> part_of_edge;  ///< for each section edge the part whose boundary it is, or kNoPart
    std::vector<SurfacePart> parts;
};

/// Floods the triangles collected so far: all triangles that share two points are connected. O(n).
FoundParts find_parts(SideBuilder& builder, Crossings& crossings, const Section& section, const Plane& plane,
                      double noise);

/// The piece of each part: group_pieces(). O(n); if a solid falls apart, one more loop over the side's triangles for
/// the rays of its whole cavities.
BySide<std::vector<std::uint32_t>> find_pieces(const BySide<SideBuilder>& builders, const Section& section,
                                               const BySide<FoundParts>& parts, const Plane& plane);

/// Takes a fragment apart, each piece with just the vertices and points that it uses, in their old order. O(n).
std::vector<Fragment> extract_pieces(const Fragment& whole, std::span<const std::uint32_t> piece_of_triangle);

}  // namespace kerf::core::linear
