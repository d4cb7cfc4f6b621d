#pragma once

#include <cstdint>
#include <limits>

#include "common/mesh/coordinate_grain.h"
#include "common/mesh/triangle_soup.h"

namespace kerf::core {

/// Facts of a mesh before repair, welded by bit-equal position; only `open_edges` is the number that repair leaves.
struct MeshFacts
{
    std::uint64_t triangles = 0;
    std::uint64_t vertices = 0;         ///< as given
    std::uint64_t welded_vertices = 0;  ///< different positions
    std::uint64_t degenerate_triangles = 0;
    std::uint64_t duplicate_triangles = 0;  ///< same three points as an earlier one, in the same orientation
    std::uint64_t boundary_edges = 0;       ///< edges with one triangle
    std::uint64_t boundary_loops = 0;       ///< connected parts of the boundary
    std::uint64_t nonmanifold_edges = 0;    ///< edges with more than two triangles
    std::uint64_t nonmanifold_points = 0;   ///< points around which the triangles, joined by shared edges, form more
                                            ///< than one vertex fan
    std::uint64_t misoriented_edges = 0;    ///< edges whose two triangles run along them in the same direction
    std::uint64_t unbalanced_edges = 0;     ///< edges along which more triangles run one way than the other
    std::uint64_t open_edges = 0;           ///< sides of triangles that have no neighbour once the mesh is repaired:
                                            ///< 0 if no edge is unbalanced
    std::uint64_t shells = 0;               ///< components connected by edges, non-manifold ones too
    double shortest_edge = std::numeric_limits<double>::infinity();  ///< mesh units; infinite without edges
    double area = 0.0;                                               ///< of the surface, mesh units squared
    double volume = 0.0;  ///< signed, by tetrahedra from the box centre; for an open mesh, which has none, from the
                          ///< origin
    Box bounds;

    /// Whether the mesh that repair() makes has no boundary. The mesh as given is closed if no edge is unbalanced.
    bool closed() const { return open_edges == 0; }
    bool manifold() const { return nonmanifold_edges == 0 && nonmanifold_points == 0; }
    bool oriented() const { return misoriented_edges == 0; }
    bool has_coarse_coordinates() const { return core::has_coarse_coordinates(shortest_edge, bounds); }
};

/// Measures triangles as repair() does on its way; for those that are not repaired. Without triangles and with an index
/// out of range, all counts and sums are 0, the shortest edge is infinite and the bounds are empty. O(n log n).
MeshFacts measure(const TriangleSoup& soup);

/// Measures a mesh or a fragment by its point ids, caps included; `welded_vertices` counts points. With an index or a
/// point id out of range the result is the same as above. O(n log n).
MeshFacts measure(const IndexedMesh& mesh);

}  // namespace kerf::core
