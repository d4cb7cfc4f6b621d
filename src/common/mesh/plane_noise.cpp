#include "common/mesh/plane_noise.h"

#include "common/mesh/float_range.h"
#include "common/mesh/tolerances.h"

namespace kerf::core {

double plane_noise(float largest_coordinate)
{
    return kNoiseInUnits * unit_in_last_place(largest_coordinate);
}

}  // namespace kerf::core
