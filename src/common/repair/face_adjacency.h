#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/repair/edge_runs.h"

namespace kerf {

/// An edge where more than two triangles met: all of its half-edges.
using NonmanifoldEdge = std::vector<std::uint32_t>;

/// Triangles by point id and who is the neighbour of whom. After link_surface() every edge has at most two triangles,
/// and these run along it in opposite directions.
struct LinkedSurface
{
    Buffer<Triangle> corners;        ///< point ids; turned over where `flipped` says so
    Buffer<std::uint32_t> opposite;  ///< for each half-edge the one across, or kNone at the boundary
    Buffer<std::uint8_t> flipped;    ///< for each triangle whether it was turned over, by exchanging corners 1 and 2
    std::uint64_t nonmanifold_edges = 0;   ///< more than two triangles met there
    std::uint64_t unorientable_edges = 0;  ///< cut open because no orientation satisfies both sides

    std::uint32_t start(std::uint32_t h) const { return corners[h / 3][h % 3]; }
    std::uint32_t end(std::uint32_t h) const { return start(next_halfedge(h)); }

    /// Whether two half-edges are of triangles with the same points in the same orientation.
    bool coincide(std::uint32_t a, std::uint32_t b) const
    {
        return start(a) == start(b) && end(a) == end(b) && start(previous_halfedge(a)) == start(previous_halfedge(b));
    }

    void link(std::uint32_t a, std::uint32_t b)
    {
        if (a != kNone) opposite[a] = b;
        if (b != kNone) opposite[b] = a;
    }

    /// Turns over the triangles for which flip[t] is not 0; opposite half-edges and `flipped` follow. O(n).
    void turn_over(std::span<const std::uint8_t> flip);
};

/// The number that a half-edge gets when its triangle is turned over.
inline std::uint32_t turned_over(std::uint32_t h)
{
    return h - h % 3 + (2 - h % 3);
}

/// Finds each triangle's neighbours. Edges with two triangles join them; patches of triangles that are joined so are
/// made to agree on an orientation by turning over the smaller part, and cut open where no orientation satisfies both
/// sides (a Moebius strip). Where an even number of triangles, more than two, is not balanced at an edge then, patches
/// are turned over as find_turned_sheets() says. Where more than two triangles meet, they are sorted around the edge
/// and paired so that two bound the same wedge of solid; what finds no partner becomes boundary. Triangles that
/// coincide are no neighbours of one another. As many half-edges find no partner at an edge as more run along it one
/// way than the other, once patches are oriented. `corners` holds three different points for each triangle; `positions`
/// belong to the points. `resolved` receives the edges of the last kind. O(n) plus sorting at each such edge.
LinkedSurface link_surface(Buffer<Triangle> corners, std::span<const glm::vec3> positions,
                           std::vector<NonmanifoldEdge>& resolved);

/// How many half-edges link_surface() leaves without a neighbour; that does not depend on where the points are.
/// `corners` holds three different points for each triangle, all below `point_count`. O(n) for bounded valence, O(n log
/// n) otherwise.
std::uint64_t count_open_edges(Buffer<Triangle> corners, std::uint32_t point_count);

}  // namespace kerf
