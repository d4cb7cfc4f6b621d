#pragma once

#include <cstdint>
#include <vector>

#include "common/cutting/cut.h"

// What a back end needs to keep the contract, and its users do not: draw ranges, the material of caps, and
// whether caps exceed their section.
//
// A cut misses for one of three reasons, and each back end finds it as soon as it can: the object lies beyond
// the plane (halfedge/cut/find.h: missed_side(); baseline/slice.cpp: bounds), a side keeps no triangle, or nothing
// crosses but what vanishes (cutter.cpp: plan(); baseline/slicing_steps.h: vertices, and sides that vanish).

namespace kerf::core {

/// Sorts ranges by kind, material and place, and joins those that follow one another.
void merge_ranges(std::vector<DrawRange>& ranges);

/// Appends the material that fills sections when the user names none, and returns its index: "cap", or "cap.1" and so
/// on if a material has that name: caps never share one with the surface by accident. The number is the smallest that
/// is free, or another if names occur twice. O(materials); allocates nothing if there is room for one.
std::uint32_t add_cap_material(std::vector<Material>& materials);

/// Whether caps cover so much more than their section that it is not rounding: more than kCapAgreement of it, and more
/// than a unit in the last place along its outline.
///
/// @param excess          area of all cap triangles, each counted positive, less `section_area`; mesh units squared
/// @param section_length  of the closed loops, mesh units
/// @param unit            in the last place of the largest coordinate, mesh units
bool caps_exceed_section(double excess, double section_area, double section_length, double unit);

}  // namespace kerf::core
