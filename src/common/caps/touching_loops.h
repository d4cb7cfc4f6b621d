#pragma once

#include <vector>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Which edge of an outline follows which. Where loops touch in a point, or one touches itself, several corners share a
/// place, and the loops may run through one another there. They are joined anew, so that the inside of each corner is one
/// wedge: then loops touch, but do not cross. Two loops may become one by that, and one two; the edges stay as they are.
struct Succession
{
    std::vector<Index> after;  ///< for each edge the next one; edges have the numbers of the points that they leave
    /// Points where an edge is followed by one that leaves another point at the same position, and all others there.
    std::vector<Index> shared;
};

/// Leaves a place as it is if the outline does not wind 0 and 1 times around it by turns, or if edges fall together.
/// O(k log k).
void part_touching_loops(const CapOutline& outline, Succession& succession);

}  // namespace kerf::core
