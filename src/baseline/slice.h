#pragma once

#include "baseline/baseline.h"
#include "linear/slices.h"

namespace kerf::core::baseline {

using linear::Fragment;
using linear::Slices;

/// Cuts a fragment by the report's method (section 3.2): one loop over all triangles. A triangle that does not cross
/// goes to its side, a crossing one is divided, and a fan from the section's centre closes both sides. `whole` is left
/// unchanged. O(n); with the quadratic lookups O(n^2).
Slices slice(const Fragment& whole, const Plane& plane, const CutOptions& options, VertexLookup lookup);

}  // namespace kerf::core::baseline
