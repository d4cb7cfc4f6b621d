#pragma once

#include "common/repair/halfedges_by_edge.h"
#include "common/repair/mesh_facts.h"
#include "common/repair/triangle_faults.h"

// The steps of measure(). repair() takes the same ones, with the welding, faults and edges that it needs anyway.

namespace kerf::core {

/// The numbers of triangles, vertices, positions and faults. O(n).
MeshFacts count_triangles(std::size_t vertex_count, std::uint32_t point_count, const Faults& faults);

/// Whether no edge has more than two triangles, and these agree: shells and points of the soup are those of its
/// repaired surface. After its edges and repeats are counted.
inline bool is_linked_plainly(const MeshFacts& facts)
{
    return facts.duplicate_triangles + facts.nonmanifold_edges + facts.misoriented_edges == 0;
}

/// Counts edges and the loops of the boundary. `edges` are those of `corners`, without degenerate triangles. O(n).
void count_edges(MeshFacts& facts, std::uint32_t point_count, std::span<const Triangle> corners,
                 HalfedgesByEdge& edges);

/// Counts shells and non-manifold points. O(n) up to the inverse Ackermann function.
void count_components(MeshFacts& facts, std::uint32_t point_count, std::span<const Triangle> corners,
                      HalfedgesByEdge& edges);

/// Counts edges, loops, shells and points, of all triangles that are not degenerate. O(n) up to the inverse Ackermann
/// function.
void count_connectivity(MeshFacts& facts, std::uint32_t point_count, std::span<const Triangle> corners,
                        const Faults& faults);

/// Bounds, area, volume and the shortest edge. The open edges are counted before. O(n).
void measure_geometry(MeshFacts& facts, std::span<const Vertex> vertices, std::span<const Triangle> triangles);

}  // namespace kerf::core
