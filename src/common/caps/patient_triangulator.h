#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Closes loops with holes, islands in these, and single loops that clipping_triangulator.h refuses (spirals, combs whose
/// teeth lean over one another): joins holes to what is around them (hole_bridges.h), and clips one ear after the other.
/// Refuses loops that cross, most that touch, and what takes more than some seconds. O(k log k) for few holes side
/// by side, and if ears lie over few reflex corners.
std::unique_ptr<CapTriangulator> make_patient_triangulator();

}  // namespace kerf::core
