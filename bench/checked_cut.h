#pragma once

#include <memory>
#include <string>
#include <vector>

#include "baseline/report_costs.h"
#include "common/cutting/cut.h"
#include "common/proxy/collision_proxy.h"

namespace kerf::bench {

/// `count` planes with seeded random directions through the centre of a box: the report's "10 cuts" through the middle.
std::vector<Plane> planes_through_the_middle(const Box& bounds, std::uint32_t count, std::uint64_t seed);

/// What a cut counted, without its times.
struct CutCounts
{
    CutStatistics all;
    baseline::ReportCosts report;
};

/// Cuts a clone of `object` and looks at the result: both sides closed, volumes and surface areas add up to the
/// whole's. Empty when all is right, otherwise what is wrong: such a result is not timed. What the cut counted is added
/// to `counted` when that is given.
std::string check_cut(const Cuttable& object, const Plane& plane, CutCounts* counted = nullptr);

/// Volume of the convex body that a proxy stands for, mesh units cubed. O(points log points).
double proxy_volume(const CollisionProxy& proxy);

/// Whether a proxy is one of these vertices: boxes and spheres hold all of them, hulls reach as far in each support
/// direction and have corners among them. Empty when it is.
std::string check_proxy(const CollisionProxy& proxy, std::span<const Vertex> vertices);

}  // namespace kerf::bench
