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

/// Calls visit(corner) for each corner of the fan of corner `h`, counter-clockwise; an open fan from its first
/// triangle.
template <class Visit>
void for_each_in_fan(const LinkedSurface& surface, std::uint32_t h, Visit&& visit)
{
    // Clockwise to the beginning of an open fan, or once around a closed one.
    std::uint32_t first = h;
    while (surface.mates[first] != kNoTwin) {
        first = next_half_edge(surface.mates[first]);
        if (first == h) break;
    }
    std::uint32_t corner = first;
    do {
        visit(corner);
        corner = surface.mates[previous_half_edge(corner)];
    } while (corner != kNoTwin && corner != first);
}

}  // namespace kerf
