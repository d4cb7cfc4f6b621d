#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "baseline/fragment.h"
#include "baseline/section.h"
#include "baseline/side_builder.h"
#include "common/pieces.h"

namespace kerf::baseline {

/// One side before its cap, flooded over its edges.
struct PartsOfSide
{
    std::vector<std::uint32_t> part_of_triangle;
    std::vector<std::uint32_t> part_of_edge;  ///< for each section edge the part whose boundary it is
    std::vector<SurfacePart> parts;
};

/// Floods the triangles collected so far, edge by edge. O(n).
PartsOfSide find_parts(SideBuilder& builder, Crossings& crossings, const Section& section);

/// Which piece of a side everything belongs to.
struct PiecesOfSide
{
    std::vector<std::uint32_t> of_triangle;  ///< its cap included
    std::vector<std::uint32_t> of_path;
};

/// Finds the pieces of a side. `paths` link edges of equal part and are in the order in which close_with_fan() got
/// them. O(n), and for each whole cavity of a solid that falls apart a loop over the side's triangles.
PiecesOfSide find_pieces(const SideBuilder& builder, const Section& section, const PartsOfSide& parts,
                         std::span<const SectionPath> paths, const Plane& plane);

/// Takes a fragment apart, each piece with just the vertices and points that it uses, in their old order. O(n).
std::vector<Fragment> extract_pieces(const Fragment& whole, std::span<const std::uint32_t> piece_of_triangle);

}  // namespace kerf::baseline
