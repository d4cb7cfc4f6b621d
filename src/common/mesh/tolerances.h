#pragma once

// All tolerances of the library, each with its unit and its reason; docs/floating-point.md has them as a table. None of
// them moves a point of the surface. Limits of work (kMost..., kFew...) stand where they are used.

namespace kerf {

/// Units in the last place of the prepared mesh's largest coordinate, as plane_noise(): how far from the plane a side
/// must reach to be a fragment. Cut points are rounded to float, so that a cap wanders from its plane by about one
/// unit; a second cut by the same plane must find nothing.
inline constexpr double kNoiseInUnits = 4.0;

/// Share of 1: how far from 1 the length of a unit vector may be. One that was stored as float or was turned by a matrix
/// is still meant; a normal of a file that is farther from it is made unit, one that is nearer keeps its bits.
inline constexpr double kUnitTolerance = 1e-6;

/// Squared length by which a normal that is given to repair() may differ from 1 before it is made unit: a normal of six
/// digits or so that is good enough comes back with the same bits.
inline constexpr double kRepairedUnitTolerance = 1e-3;

/// Units in the last place of the largest coordinate: shorter edges are too short for their mesh. Cut points on them
/// have hardly anywhere to go, and volumes and areas are those of a mesh that was rounded on the way here. Four bits: a
/// cut point then still divides an edge to 1/16. A warning only.
inline constexpr double kCoarseUnits = 16.0;

/// Radians: triangles at an edge whose directions differ by no more stand in one direction. Rounding of their corners
/// turns them by a few 1e-7.
inline constexpr double kSameAngle = 1e-6;

/// Share of an open shell's area: if its boundary loops, each closed by a fan over its centre, have no more, the shell
/// has an inside. A head with open eye sockets has one; a terrain or a bowl has none, and neither can be inside out.
inline constexpr double kLargestHole = 0.1;

/// Degrees: edges whose triangles turn by more stay sharp if normals are made.
inline constexpr double kCreaseAngle = 40.0;

/// Share of the section's area by which caps may differ from it: what rounding cut points to float costs. A warning
/// only.
inline constexpr double kCapAgreement = 1e-6;

/// Share of the area of all others: parts of an outline that run clockwise and have no more are no holes. Rounding has
/// turned them over, and covering them turned over as well costs less than anyone asks for.
inline constexpr double kTurnedShare = 1e-8;

/// Share of the cube of the distance: a sum about a point so far away has no digits left for a smaller volume. It is
/// summed anew about a nearer point.
inline constexpr double kLostDigits = 1e-11;

/// Parts of the hull's lattice: a hull that is thinner is flat. Rounding to the lattice moves either side by one part.
inline constexpr double kThinnestInParts = 2.0;

}  // namespace kerf
