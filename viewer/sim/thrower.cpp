#include "viewer/sim/thrower.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "common/support/random.h"
#include "viewer/sim/camera.h"

namespace kerf::sim {
namespace {

/// Start and landing are at most so far from the middle, shares of the half width: the whole object stays in view.
constexpr double kStartSpread = 0.45, kLandingSpread = 0.6;
/// Apex, shares of the half height: the upper third of the stage begins at 1/3, and an object's top stays in view.
constexpr double kLowestApex = 0.35, kHighestApex = 0.65;
/// rad/s
constexpr double kSlowestSpin = 0.5, kFastestSpin = 2.0;
/// How far below the stage's edge the centre starts, in radii: out of view with some room.
constexpr double kStartBelow = 1.2;

// Numbers are drawn in statements of their own, last coordinate first: in which order the arguments of a call are
// evaluated is the compiler's choice, and a seed is the same throw with any compiler.

double between(core::Random& random, double low, double high)
{
    return low + (high - low) * random.unit();
}

/// Uniform on the sphere, from the ball by rejection.
glm::dvec3 random_axis(core::Random& random)
{
    for (;;) {
        const double z = between(random, -1, 1), y = between(random, -1, 1), x = between(random, -1, 1);
        const glm::dvec3 p(x, y, z);
        const double square = glm::dot(p, p);
        if (square <= 1.0 && square > 0.01) return p / std::sqrt(square);
    }
}

/// Uniform over all rotations: a uniform unit quaternion.
glm::dmat3 random_rotation(core::Random& random)
{
    for (;;) {
        const double z = between(random, -1, 1), y = between(random, -1, 1), x = between(random, -1, 1);
        const glm::dquat q(between(random, -1, 1), x, y, z);
        const double square = glm::dot(q, q);
        if (square <= 1.0 && square > 0.01) return glm::mat3_cast(q / std::sqrt(square));
    }
}

}  // namespace

Flight plan_flight(std::uint64_t seed, double gravity, double radius)
{
    core::Random random(seed);
    Flight flight;
    const double start = between(random, -kStartSpread, kStartSpread) * kStageHalfWidth;
    const double landing = between(random, -kLandingSpread, kLandingSpread) * kStageHalfWidth;
    const double below = kStageHalfHeight + kStartBelow * radius;
    flight.apex = between(random, kLowestApex, kHighestApex) * kStageHalfHeight;
    flight.centre = {start, -below, 0.0};

    const double up = std::sqrt(2.0 * gravity * (flight.apex + below));
    flight.motion.velocity = {(landing - start) * gravity / (2.0 * up), up, 0.0};
    const double spin = between(random, kSlowestSpin, kFastestSpin);
    flight.motion.spin = random_axis(random) * spin;
    flight.rotation = random_rotation(random);
    return flight;
}

}  // namespace kerf::sim
