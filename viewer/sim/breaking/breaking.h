#pragma once

#include <kerf/fracture.h>

#include <cstdint>
#include <glm/vec3.hpp>

namespace kerf::sim {

/// How an object breaks.
struct Breaking
{
    FracturePattern pattern = FracturePattern::impact;
    std::uint32_t cells = 24;
    /// What a square metre of a contact between two pieces passes on before it breaks, N s: 0, and everything falls apart.
    double strength = 0.0;
    double speed = 2.0;  ///< with which the outermost of what falls apart leaves the others, m/s
};

/// A blow on an object.
struct Blow
{
    glm::dvec3 place{0.0};    ///< world, metres
    glm::dvec3 impulse{0.0};  ///< N s
    /// It comes along a line from `place`, and strikes where that meets the object's surface first; the direction, of length
    /// 1. All zero: it strikes at `place`.
    glm::dvec3 along{0.0};
    /// Whether it moves the object; the blow of another body has done so already.
    bool pushes = true;
};

/// How fast a blow of the blade makes an object go, m/s.
inline constexpr double kBladeBlow = 1.5;
/// With what speed parts leave each other that a collision broke, m/s.
inline constexpr double kCollisionParting = 0.5;

}  // namespace kerf::sim
