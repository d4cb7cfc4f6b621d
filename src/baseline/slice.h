#pragma once

#include <optional>
#include <vector>

#include "baseline/baseline.h"
#include "baseline/fragment.h"
#include "common/cutting/cut.h"

namespace kerf::baseline {

/// The two sides of a cut, each as one fragment or as its pieces.
struct Slices
{
    Status status = Status::missed;        ///< done, open_section or missed
    Side side_of_object = Side::negative;  ///< see CutResult
    std::vector<Fragment> positive, negative;
    double section_area = 0.0;
    bool caps_exceed_section = false;
    CutStatistics statistics;
    std::uint64_t vertex_comparisons = 0;  ///< see ReportCosts
};

/// Cuts a fragment by the report's method (section 3.2): one loop over all triangles. A triangle that does not cross
/// goes to its side, a crossing one is divided, and a fan from the section's centre closes both sides. `whole` is left
/// unchanged. O(n); with the quadratic lookups O(n^2).
Slices slice(const Fragment& whole, const Plane& plane, const CutOptions& options, VertexLookup lookup);

/// The report's loop over all vertices of a fragment (section 3.2.4): writes each vertex relative to their mean, the
/// new pivot, into `scratch`, and returns the pivot. Nothing else changes: a pivot belongs in the fragment's transform.
/// O(n).
glm::vec3 rewrite_around_pivot(const IndexedMesh& mesh, Buffer<Vertex>& scratch);

}  // namespace kerf::baseline
