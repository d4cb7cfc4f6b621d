#pragma once

#include <cstddef>
#include <cstdint>

#include "viewer/sim/pose.h"

namespace kerf::sim {

/// Objects are scaled so that their box's half diagonal is this, metres: a quarter of the stage's height across.
inline constexpr double kThrownRadius = 1.1;

/// A throw, decided by one number.
struct Throw
{
    std::size_t model = 0;
    std::uint64_t seed = 0;
    double radius = kThrownRadius;  ///< half the diagonal of its box, metres

    friend bool operator==(const Throw&, const Throw&) = default;
};

/// How an object starts: just below the stage, on a parabola.
struct Flight
{
    glm::dvec3 centre{0.0};    ///< of the mesh's box, world, metres; z = 0
    glm::dmat3 rotation{1.0};  ///< mesh axes to world axes
    Motion motion;             ///< of the centre of mass; velocity.z = 0
    double apex = 0.0;         ///< height that the centre reaches, metres
};

/// From below the stage to an apex in its upper third and down again inside its width, with a little spin (0.5 to 2
/// rad/s about any axis). The same seed gives the same flight everywhere: only exactly rounded operations.
/// @param radius  of the object, metres: how far below the stage it starts
Flight plan_flight(std::uint64_t seed, double gravity, double radius = kThrownRadius);

}  // namespace kerf::sim
