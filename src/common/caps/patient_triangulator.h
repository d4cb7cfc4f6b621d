#pragma once

#include <memory>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Closes one simple loop by clipping one ear after the other: also spirals, and combs whose teeth lean over one another,
/// which clipping_triangulator.h refuses. Refuses nested loops, loops that cross themselves, and those that take more
/// than a second. O(k log k) for spirals, O(k^2) if ears lie over many reflex corners.
std::unique_ptr<CapTriangulator> make_patient_triangulator();

}  // namespace kerf::core
