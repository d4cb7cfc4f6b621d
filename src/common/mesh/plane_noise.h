#pragma once

#include "common/mesh/tolerances.h"

namespace kerf::core {

/// How far from the plane a side must reach to be a fragment: kNoiseInUnits units in the last place of the mesh's
/// largest coordinate, in mesh units. `largest_coordinate` is that of the mesh before any cut
/// (Box::largest_coordinate).
double plane_noise(float largest_coordinate);

/// One unit in the last place of that coordinate, by which rounding moves a cut point at most along an axis.
inline double rounding_unit(double plane_noise)
{
    return plane_noise / kNoiseInUnits;
}

}  // namespace kerf::core
