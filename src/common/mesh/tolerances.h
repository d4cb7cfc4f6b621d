#pragma once

// All tolerances of the library, each with its unit and its reason; docs/floating-point.md lists them in a table. None
// of them moves a point of the surface. Limits of work and of counts (kMost..., kFew..., kCrowd) stand where they are
// used.

#include <cstddef>

namespace kerf::core {

/// Units in the last place of the prepared mesh's largest coordinate, as plane_noise(): how far from the plane a side
/// must reach to be a fragment. Cut points are rounded to float, so a cap deviates from its plane by about one unit; a
/// second cut by the same plane must find nothing.
inline constexpr double kNoiseInUnits = 4.0;

/// Share of 1: how far from 1 the length of a unit vector may be. A vector that was stored as float or turned by a
/// matrix still passes. A vertex normal that is farther from 1 is made unit; a nearer one keeps its bits.
inline constexpr double kUnitTolerance = 1e-6;

/// Units in the last place of the largest coordinate: shorter edges are too short for their mesh. Hardly any floats lie
/// between their ends for cut points, and volumes and areas are those of the mesh as it was rounded. With four bits a
/// cut point still divides an edge to 1/16. A warning only.
inline constexpr double kCoarseUnits = 16.0;

/// Radians: triangles at an edge count as having the same direction if their directions differ by no more. Rounding of
/// their corners turns them by a few 1e-7.
inline constexpr double kSameAngle = 1e-6;

/// Share of an open shell's area: the shell has an inside if triangles from the centres of its boundary loops to their
/// edges have no more. A head with open eye sockets has one; a terrain or a bowl has none, and neither can be inside
/// out.
inline constexpr double kLargestHole = 0.1;

/// Degrees: if normals are computed, edges whose triangles turn by more stay sharp.
inline constexpr double kCreaseAngle = 40.0;

/// Sine of an angle: of a direction that is no farther from a plane's normal, nothing is left in the plane but rounding
/// of doubles.
inline constexpr double kNoDirection = 1e-12;

/// Share of the section's area by which caps may exceed it: the cost of rounding cut points to float. A unit in the
/// last place along the outline is allowed as well: caps_exceed_section(). A warning only.
inline constexpr double kCapAgreement = 1e-6;

/// Share of the area of all other loops: clockwise loops of an outline that have no more area are not holes. Rounding
/// has turned them over; if they are covered turned over as well, the error is negligible.
inline constexpr double kTurnedShare = 1e-8;

/// Points of an outline for each that rounding may have moved across an edge: with more, the outline is given up. One
/// in forty thousand was seen in sections that were capped rightly, one in ten in those that were not.
inline constexpr std::size_t kPointsForMoved = 100;

/// Share of an outline's largest coordinate: points that differ only along the axis that is dropped are moved apart by
/// this much, which is 2^24 times less than a float can tell.
inline constexpr double kNudge = 0x1p-48;

/// Half sizes of the box, along its largest side: a mesh whose centre is no farther from the origin is summed about the
/// origin, which is cheapest. Terms grow with the fifth power of the distance: twice as far costs 5 of the 53 bits.
inline constexpr double kHalfSizesFromOrigin = 2.0;

/// Multiples of plane_noise(): how far sums about the mesh's reference point may reach at least, a quarter of the
/// largest coordinate or more. With kLostDigits it decides which volumes have no digits left.
inline constexpr double kReachInNoise = 0x1p20;

/// Share of the cube of the distance: a sum about a point so far away has no digits left for a smaller volume. The
/// volume is then summed again about a nearer point.
inline constexpr double kLostDigits = 1e-11;

/// Steps of the hull's lattice: a thinner hull is flat. Rounding to the lattice moves either side by one step.
inline constexpr double kThinnestInSteps = 2.0;

}  // namespace kerf::core
