#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/cutting/cut.h"
#include "linear/fragment.h"

namespace kerf::core::linear {

/// The two sides of a cut, each as one fragment or as its pieces.
struct Slices
{
    Status status = Status::missed;        ///< done, open_section or missed
    Side side_of_object = Side::negative;  ///< see CutResult
    std::vector<Fragment> positive, negative;
    double section_area = 0.0;
    bool caps_exceed_section = false;
    CutStatistics statistics;
    std::uint64_t vertex_comparisons = 0;  ///< by look-ups that compare vertices
};

/// The report's exclusion, here by the bounds: where a fragment lies that the plane misses. Nothing if the plane may meet
/// it. O(1).
inline std::optional<Side> missed_by_bounds(const Fragment& whole, const Plane& plane)
{
    const auto [least, most] = plane.distance_range(whole.bounds);
    if (most > whole.noise && least < -whole.noise) return std::nullopt;
    return most <= whole.noise ? Side::negative : Side::positive;
}

/// What such a miss costs: nothing.
inline Slices missed_slices(const Fragment& whole, Side side_of_object)
{
    Slices missed;
    missed.statistics.triangles = whole.mesh.triangles.size();
    missed.side_of_object = side_of_object;
    return missed;
}

}  // namespace kerf::core::linear
