#pragma once

#include <cstdint>
#include <vector>

#include "common/mesh/triangle_soup.h"

namespace kerf::core::shapes {

/// A point of a profile in the half plane r >= 0, with the profile's normal there.
struct ProfilePoint
{
    double r = 0.0, z = 0.0;
    double normal_r = 0.0, normal_z = 0.0;  ///< any length
};

/// A run of a profile without a sharp corner. Where one run ends and the next begins both have the same r and z.
using ProfileRun = std::vector<ProfilePoint>;

/// A straight run divided into equal parts; the normal is to the right of the direction of travel.
ProfileRun straight_run(double r0, double z0, double r1, double z1, std::uint32_t parts);

/// Turns a profile around z. Outside is to the right of the direction of travel (upwards: away from the axis). Points
/// with r = 0 are on the axis: one triangle a slice there, two elsewhere. The profile begins and ends on the axis, or
/// at the same point, for a closed surface. slices >= 3. Directions come from the C library's sin and cos.
TriangleSoup turn(const std::vector<ProfileRun>& profile, std::uint32_t slices);

}  // namespace kerf::core::shapes
