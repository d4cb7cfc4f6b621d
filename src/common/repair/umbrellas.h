#pragma once

#include <cstdint>
#include <span>

#include "common/repair/edge_runs.h"

namespace kerf {

/// The number of points whose triangles form more than one umbrella, if two triangles that share any edge at the point
/// count as neighbours, however many meet there. `corners` holds three different point ids for each triangle and
/// `edges` their edges. O(n) up to the inverse Ackermann function.
std::uint64_t count_umbrella_points(std::uint32_t point_count, std::span<const Triangle> corners,
                                    const EdgeRuns& edges);

}  // namespace kerf
