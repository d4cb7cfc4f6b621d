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

/// The report's loop over all vertices of a fragment (section 3.2.4): writes each vertex relative to their mean, the
/// new pivot, into `scratch`, and returns the pivot. Nothing else changes: a pivot belongs in the fragment's transform.
/// O(n).
glm::vec3 rewrite_around_pivot(const IndexedMesh& mesh, Buffer<Vertex>& scratch);

}  // namespace kerf::core::baseline
