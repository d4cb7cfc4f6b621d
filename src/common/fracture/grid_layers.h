#pragma once

#include <array>
#include <cstdint>

#include "common/fracture/inside_points.h"
#include "common/mesh/box.h"

namespace kerf::core {

/// How often a box is divided along each axis.
using Layers = std::array<std::uint32_t, 3>;

/// How to divide a box into smaller ones, as cubic as can be, of which about so many hold a part of a solid. Fewer do if the
/// solid fills next to nothing of its box.
///
/// @param box      of the solid; no side is 0
/// @param sample   of the solid: what of it lies between its lines is not seen
/// @param wanted   how many boxes, at least 1
///
/// O((r + s) log s) for r runs of the sample and s boxes, at most 10^5.
Layers layers_for(const Box& box, const InsideSample& sample, std::size_t wanted);

}  // namespace kerf::core
