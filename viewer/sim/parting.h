#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "viewer/sim/pose.h"

namespace kerf::sim {

/// A piece at the moment of a cut.
struct Part
{
    bool positive = false;    ///< which side of the plane
    double mass = 0.0;        ///< kg
    glm::dvec3 centre{0.0};   ///< of mass, world, metres
    glm::dmat3 inertia{0.0};  ///< about the centre, world axes, kg m^2
    Motion motion;            ///< what part_ways() fills in
};

/// How fast the two sides' centres leave each other, m/s: they are 5 cm apart when siblings begin to collide.
inline constexpr double kPartingSpeed = 0.5;
/// The kick never adds more spin than this to a side, rad/s: slivers would whirl otherwise.
inline constexpr double kFastestKickSpin = 4.0;

/// Motion of the pieces of a body that a plane has just divided. Until then it was one rigid body (`centre`, `motion`),
/// so each piece inherits v + w x r at its own centre and w. Then the two sides, each still rigid, push each other
/// apart along the plane's normal by equal and opposite impulses at one common point (where the line between their
/// centres crosses the plane), and each side's pieces inherit from it. Linear and angular momentum are unchanged to
/// rounding.
///
/// @param normal   unit, world axes, towards the positive side
/// @param on_plane a point of the plane, world
/// O(parts).
void part_ways(const glm::dvec3& centre, const Motion& motion, const glm::dvec3& normal, const glm::dvec3& on_plane,
               std::span<Part> parts, double parting_speed = kPartingSpeed);

}  // namespace kerf::sim
