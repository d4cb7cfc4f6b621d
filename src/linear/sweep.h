#pragma once

#include <memory>
#include <span>

#include "common/cutting/cut.h"
#include "linear/fragment.h"

namespace kerf::core::linear {

/// The sections of a fragment by parallel planes in one sweep: the heights of its vertices are found once, and each plane
/// gets the triangles between whose lowest and highest corner it lies. What find_outline() gives, bit for bit, because a
/// signed distance is a vertex's height less the plane's offset. O(n log h + k) for n triangles, h planes and k pairs of a
/// plane and a triangle that it meets; then O(k) for each plane. May throw std::bad_alloc and Cancelled.
///
/// @param whole   stays as it is as long as the search is used
/// @param normal  of unit length
std::unique_ptr<StackSearch> sweep(const Fragment& whole, const glm::dvec3& normal, std::span<const double> offsets,
                                   const ProgressOfStep& progress);

}  // namespace kerf::core::linear
