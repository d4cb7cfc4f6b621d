#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/repair/halfedges_by_edge.h"
#include "common/repair/linked_surface.h"

namespace kerf::core {

/// Which vertex fan each corner of a surface is in. A vertex fan is a run of triangles around a point in which each is
/// the neighbour of the next. Corners are numbered like half-edges.
struct VertexFans
{
    Buffer<std::uint32_t> fan;  ///< for each corner
    std::uint32_t count = 0;
    bool is_one_at_each_point = false;  ///< known for whole meshes only
    std::uint64_t steps = 0;            ///< work of dividing fans: half-edges compared and corners passed
};

/// Numbers the vertex fans in the order of their first corner. If the surface passes an edge of `resolved` twice with
/// both ends in the same fans, the partners at that edge are exchanged. This divides the fan at either end: afterwards
/// no directed edge occurs twice between the same two fans. Pairs of half-edges are taken in the order of `resolved`;
/// the part with the first of a pair gets a new number. O(n), and O(k log^2 k) for k corners of fans that are divided
/// again and again. If `is_used` is given, 1 is written there for each point that has a fan.
VertexFans find_vertex_fans(LinkedSurface& surface, std::span<const NonmanifoldEdge> resolved,
                            std::span<std::uint8_t> is_used = {});

/// The number of points with more than one fan, if two triangles that share any edge at the point count as neighbours,
/// however many meet there. `corners` holds three different point ids for each triangle and `edges` their edges. O(n)
/// up to the inverse Ackermann function.
std::uint64_t count_nonmanifold_points(std::uint32_t point_count, std::span<const Triangle> corners,
                                       HalfedgesByEdge& edges);

}  // namespace kerf::core
