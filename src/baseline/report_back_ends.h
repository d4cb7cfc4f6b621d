#pragma once

#include <kerf/math.h>

#include <cstdint>
#include <vector>

// The report's slicer for programs that compare with it: the one header of the library that they include and that is
// not installed.

namespace kerf {

struct Cut;
class Object;

/// Adds the report's four look-ups with the fan to the back ends: "baseline/hash", "baseline/remap",
/// "baseline/two_bucket_hash", "baseline/scan". Once or again, from any thread. Throws std::bad_alloc.
void add_report_back_ends();

/// What only the report's method does in a cut, counted for both sides together.
struct ReportCosts
{
    std::uint64_t vertex_comparisons = 0;  ///< vertices compared while looking for duplicates; exact
};

/// The costs of a cut by one of them; zeros of a miss, and of a cut by another back end. Its pieces carry them: ask
/// before they are moved away. O(1).
ReportCosts report_costs(Cut& cut) noexcept;

/// What the report's bodies collide as (section 3.2.4): every vertex, added to the physics engine's hull shape one by
/// one as its program does. The shape computes its bounds anew with each of them, so this is quadratic; it is here to
/// be compared with. In the library kerf::report_proxy. O(n^2). Throws std::bad_alloc.
std::vector<Vec3f> report_collision_points(const Object& object);

}  // namespace kerf
