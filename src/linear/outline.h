#pragma once

#include "common/cutting/plane_section.h"
#include "linear/fragment.h"

namespace kerf::core::linear {

/// The outline of a section without a cut: the steps of the Slicer (slicing_steps.h) that find it, and no copy of what
/// the plane does not cross. What it needs it keeps in the section. O(n). May throw std::bad_alloc.
///
/// @param section  clear
void find_outline(const Fragment& whole, const Plane& plane, PlaneSection& section);

}  // namespace kerf::core::linear
