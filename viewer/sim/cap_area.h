#pragma once

#include <kerf/object.h>

namespace kerf::sim {

/// Area of the object's caps, mesh units squared: each triangle counts in full, however it is turned and whatever lies
/// under it. Where a cap covers more than its section, or the same place twice, this is more than the section's area.
/// O(caps).
/// @throws std::bad_alloc
double cap_area(const Object& object);

/// Whether the caps that a cut made cover its section and nothing else.
/// @param area_before  cap_area() of the object
/// @param area_after   cap_area() of all its pieces
/// @param section      Cut::section_area
bool is_closed_rightly(double area_before, double area_after, double section);

}  // namespace kerf::sim
