#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "viewer/sim/body.h"

namespace kerf::sim {

/// The exclusion test of the report's section 3.1: does the segment between two points of the stage, seen from the eye,
/// cross the body's collision proxy? The report casts a ray from point to point in the plane in which objects fly. Here
/// the ray is swept along the line of sight through the body's depth, so that pieces nearer or farther than the plane,
/// and segments that start or end inside a proxy, are judged as the player sees them. O(points of the proxy).
bool blade_hits(const glm::dvec3& eye, const glm::dvec2& from, const glm::dvec2& to, const Body& body);

}  // namespace kerf::sim
