#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "viewer/sim/crowd.h"

namespace kerf::sim {

/// A piece that wants to become a body.
struct Candidate
{
    double mass = 0.0;  ///< kg
    WorldBox box;
};

struct PieceChoice
{
    std::vector<bool> stays;  ///< for each piece
    std::size_t crowded = 0;  ///< that do not stay because of the crowd where they are
};

/// Which pieces become bodies: the heaviest, the earlier of equal ones, as many as the world has room for, and none but
/// the heaviest where so many neighbours are.
PieceChoice choose_heaviest(std::span<const Candidate> pieces, const World& world,
                            std::size_t most_neighbours = kMostNeighbours);

}  // namespace kerf::sim
