#pragma once

#include <cstdint>

#include "viewer/sim/breaking/break_log.h"
#include "viewer/sim/breaking/breaker.h"
#include "viewer/sim/breaking/breaking.h"
#include "viewer/sim/world.h"

namespace kerf::sim {

/// Pieces of one break leave one another alone for so long: twice as long as those of a cut, because those within hardly
/// move.
inline constexpr Tick kBreakSiblingTicks = 24;  // 200 ms

/// In a crowd of so many only the largest piece of a break stays. More than of a cut (kMostNeighbours): the boxes of cells
/// overlap those of their neighbours and of theirs, but pieces leave one another at once, or are one body.
inline constexpr std::size_t kMostNeighboursOfBreak = 256;

/// Deals a cluster a blow: it is pushed as a whole, and where bonds can't pass the impulse on (bond_loads.h) they break.
/// Each part moves on as it moved as part of the whole, and away from the others. O(members log members + bonds).
/// @param number  of this break: its parts don't collide at first
CrackRecord crack(World& world, Cluster& cluster, const Blow& blow, double speed, std::uint64_t number);

/// How an object's pieces become bodies.
struct BreakBodyOptions
{
    Breaking how;
    glm::dvec3 impulse{0.0};      ///< of the blow, N s
    bool pushes = true;           ///< Blow::pushes
    std::uint64_t number = 0;     ///< of this break: its pieces don't collide at first
    std::uint32_t swipe = 0;      ///< that struck it; it does not cut its pieces
    ObjectId* last_id = nullptr;  ///< the last id given out; counts up
};

/// Puts the pieces of an object that was taken apart in the place of its body: where it is now, moving as it moves,
/// pushed by the blow. Bonds that hold it bind pieces to clusters (Breaking::strength); the others fly apart. Where the
/// world has no room for all the smallest are dropped, as of a cut.
///
/// Fills in of `record` what the pieces are; gives what the blow broke.
CrackRecord break_body(World& world, ObjectId id, BreakJob& job, const BreakBodyOptions& options, BreakRecord& record);

}  // namespace kerf::sim
