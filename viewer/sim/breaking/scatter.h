#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "viewer/sim/pose.h"

namespace kerf::sim {

/// One of the parts into which a rigid body has just fallen.
struct ScatteredPart
{
    double mass = 0.0;       ///< kg
    glm::dvec3 centre{0.0};  ///< of mass, world, metres
    Motion motion;           ///< as a part of the whole; scatter() adds to it
};

/// Lets parts fly away from their common centre of mass, the farther out the faster, `speed` m/s for the outermost. As all
/// velocities are multiples of the distances from that centre, parts don't run into one another, and neither momentum nor
/// angular momentum changes but by rounding. Parts around one centre stay as they are. O(parts).
void scatter(std::span<ScatteredPart> parts, double speed);

}  // namespace kerf::sim
