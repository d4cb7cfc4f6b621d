#pragma once

#include <cstdint>
#include <vector>

#include "common/cutting/cut.h"
#include "common/cutting/plane_section.h"
#include "common/mesh/plane.h"

namespace kerf::core {

/// The paths of a section that CutOptions::only means: for each whether it does.
///
/// The path nearest to the point decides; of several that are equally near that with the least point (by x, y, z). Its
/// region is the outer loop and the holes right in it that bound the same solid, or a chain alone; its solid, all paths
/// of that number. O(k log k) for k edges. May throw std::bad_alloc.
///
/// @param section  receives the measures of its paths (section_measures.h)
std::vector<bool> choose_paths(const Plane& plane, const OnlyNear& only, PlaneSection& section);

}  // namespace kerf::core
