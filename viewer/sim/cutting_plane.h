#pragma once

#include <kerf/plane.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "viewer/sim/body.h"

namespace kerf::sim {

/// A plane in the world, metres.
struct WorldPlane
{
    glm::dvec3 normal{0.0, 0.0, 1.0};  ///< unit
    glm::dvec3 point{0.0};
};

/// The plane through the eye and two points of the stage (z = 0). It points to the left of the stroke as the player
/// sees it. Empty when the points coincide or a number is not finite.
std::optional<WorldPlane> swipe_plane(const glm::dvec3& eye, const glm::dvec2& from, const glm::dvec2& to);

/// Objects are cut on planes of a grid: normal components and distance from the thrown object's centre are multiples of
/// this part of 1 and of its radius. A two-thousandth of a radius is a tenth of a pixel at 1280x720. After a first cut
/// the back ends' masses differ in the eighth digit (their caps are triangulated differently), so do positions, and
/// without a grid no second plane would be the same for both.
inline constexpr double kPlaneGrid = 0x1p-11;

/// A world plane in an object's own frame, mesh units, on the grid. `pose` is where the object stands, tumbling
/// included. Empty when no valid plane results.
std::optional<Plane> object_plane(const WorldPlane& plane, const MeshPose& pose, const Origin& origin);

/// The way back: where a plane of the object's frame lies in the world.
WorldPlane world_plane(const Plane& plane, const MeshPose& pose);

}  // namespace kerf::sim
