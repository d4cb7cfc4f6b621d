#include "viewer/sim/breaking/scatter.h"

#include <algorithm>
#include <glm/geometric.hpp>

namespace kerf::sim {
namespace {

/// Centres this near to the common one, metres, lie in it as far as rounding tells: they have no direction to fly to.
constexpr double kOnePlace = 1e-9;

}  // namespace

void scatter(std::span<ScatteredPart> parts, double speed)
{
    double mass = 0.0, farthest = 0.0;
    glm::dvec3 centre(0.0);
    for (const ScatteredPart& part : parts) {
        mass += part.mass;
        centre += part.mass * part.centre;
    }
    if (!(mass > 0.0)) return;
    centre /= mass;
    for (const ScatteredPart& part : parts) farthest = std::max(farthest, glm::distance(part.centre, centre));
    if (farthest <= kOnePlace) return;
    for (ScatteredPart& part : parts) part.motion.velocity += speed / farthest * (part.centre - centre);
}

}  // namespace kerf::sim
