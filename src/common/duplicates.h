#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/indexed_mesh.h"

namespace kerf {

/// For each triangle whether it is degenerate (two corners in one point) or a duplicate: the same three points as an
/// earlier one, in the same orientation.
enum class TriangleFault : std::uint8_t
{
    none,
    degenerate,
    duplicate,
};

/// `corners` holds the three point ids of each triangle, all below `point_count`. O(n) for bounded valence, O(n log n)
/// otherwise.
std::vector<TriangleFault> find_faults(std::uint32_t point_count, std::span<const Triangle> corners);

}  // namespace kerf
