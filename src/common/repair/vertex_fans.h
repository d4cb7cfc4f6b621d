#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/repair/face_adjacency.h"

namespace kerf {

/// Which fan each corner of a surface is in. A fan is a run of triangles around a point in which each is the neighbour
/// of the next. Corners are numbered like half-edges.
struct Fans
{
    Buffer<std::uint32_t> fan;  ///< for each corner
    std::uint32_t count = 0;
    std::uint64_t steps = 0;  ///< what dividing fans took: half-edges compared and corners passed
};

/// Numbers the fans in the order of their first corner. Where the surface passes the same edge twice with both ends in
/// the same fans, the partners at that edge (they must be in `resolved`) are exchanged: this divides the fan at either
/// end, so that afterwards no directed edge occurs twice between the same two fans: pairs of half-edges in the order of
/// `resolved`, the first keeps its place in a fan with a new number. O(n), and O(k log^2 k) for k corners of fans that
/// are divided again and again.
Fans find_fans(LinkedSurface& surface, std::span<const NonmanifoldEdge> resolved);

}  // namespace kerf
