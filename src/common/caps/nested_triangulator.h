#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Closes loops with holes, islands in these, loops that touch in points, and single loops that clipping_triangulator.h
/// refuses (spirals, combs whose teeth lean over one another): loops are joined anew where they touch, bridges lead from
/// holes to what is around them (hole_bridges.h), and the ears of what has become rings are clipped, in layers as far as that
/// goes (ear_clipper.h). Refuses loops that cross, some that touch, and what takes more looks at corners than a few hundred
/// for each point. O(k log k) if ears lie over few reflex corners.
std::unique_ptr<CapTriangulator> make_nested_triangulator();

/// The same, but it refuses only what takes more than some seconds: for builds that have no other way.
std::unique_ptr<CapTriangulator> make_patient_triangulator();

}  // namespace kerf::core
