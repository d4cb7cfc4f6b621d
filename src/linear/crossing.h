#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/cutting/cut_geometry.h"
#include "common/geometry/pair_table.h"
#include "common/mesh/indexed_mesh.h"
#include "linear/cut_point_classes.h"

namespace kerf::core::linear {

/// A triangle that the plane crosses, and how it falls apart.
struct CrossingTriangle
{
    std::uint32_t triangle;      ///< index in the mesh
    std::uint32_t group;         ///< index of its group
    std::uint32_t cut_next;      ///< cut point id of the edge lone -> next
    std::uint32_t cut_previous;  ///< cut point id of the edge previous -> lone
    TriangleSplit split;
};

/// All triangles of a mesh that cross the plane, with cut points identified across edges.
struct Crossings
{
    std::vector<CrossingTriangle> triangles;  ///< in mesh order
    CutPointClasses cut_points;
    PairTable cut_point_of_edge;  ///< by the edge's points, so that seam edges have one cut point

    /// The cut point that stands for corner `code` (kCutNext or kCutPrevious) of a crossing triangle.
    std::uint32_t cut_point(const CrossingTriangle& crossing, std::uint8_t code)
    {
        return cut_points.find(code == TriangleSplit::kCutNext ? crossing.cut_next : crossing.cut_previous);
    }
};

/// The two vertices of the edge that a cut point lies on, in the order in which split_triangle() cut it.
std::array<std::uint32_t, 2> cut_edge_vertices(const IndexedMesh& mesh, const CrossingTriangle& crossing,
                                               std::uint8_t code);

/// The attributes at corner `code` of a crossing triangle.
Vertex corner_vertex(const IndexedMesh& mesh, const CrossingTriangle& crossing, std::uint8_t code);

/// The values of one stream at corner `code` of a crossing triangle: `stream.width` of them into `result`.
void corner_stream(const IndexedMesh& mesh, const VertexStream& stream, const CrossingTriangle& crossing,
                   std::uint8_t code, float* result);

/// Splits the triangles named in `crossings` (index and group filled in) and identifies cut points that are one. O(k).
void split_crossing_triangles(const IndexedMesh& mesh, const Plane& plane, Crossings& crossings);

}  // namespace kerf::core::linear
