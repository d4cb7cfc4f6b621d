#pragma once

#include <kerf/cut.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "baseline/report_back_ends.h"

namespace kerf::bench {

/// `count` planes with seeded random directions through the centre of a box: the report's "10 cuts" through the middle.
std::vector<Plane> planes_through_the_middle(const Box& bounds, std::uint32_t count, std::uint64_t seed);

/// What a cut counted, without its times.
struct CutCounts
{
    CutStatistics all;
    ReportCosts report;
};

/// Cuts a clone of `object` and looks at the result: both sides closed, volumes and surface areas add up to the
/// whole's. Empty when all is right, otherwise what is wrong: such a result is not timed. What the cut counted is added
/// to `counted` when that is given.
std::string check_cut(const Object& object, const Plane& plane, CutCounts* counted = nullptr);

/// Whether triangles bound solids: each edge is run along as often one way as the other. `corners` has three points of
/// the surface for each triangle. O(n log n).
bool are_closed(std::span<const std::uint32_t> corners);

}  // namespace kerf::bench
