#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/repair/halfedges_by_edge.h"

// Who is whose neighbour, before a mesh is proven. Patches that face the wrong way are found in orient_patches.h and
// orient_sheets.h, whole shells in solids.h; edges of more than two triangles are taken apart in edge_pairing.h.

namespace kerf::core {

/// An edge where more than two triangles met: all of its half-edges.
using NonmanifoldEdge = std::vector<std::uint32_t>;

/// Triangles by point id, and their neighbours. After link_surface() every edge has at most two triangles, and these
/// run along it in opposite directions.
struct LinkedSurface
{
    Buffer<Triangle> corners;        ///< point ids; turned over where `flipped` says so
    Buffer<std::uint32_t> opposite;  ///< for each half-edge the one across, or kNone at the boundary
    Buffer<std::uint8_t> flipped;    ///< for each triangle whether it was turned over, by exchanging corners 1 and 2
    std::uint64_t nonmanifold_edges = 0;   ///< more than two triangles met there
    std::uint64_t unorientable_edges = 0;  ///< cut open because no orientation satisfies both sides

    std::uint32_t start(std::uint32_t h) const { return start_of(corners, h); }
    std::uint32_t end(std::uint32_t h) const { return start(next_halfedge(h)); }

    /// Whether two half-edges belong to triangles with the same points in the same orientation.
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

/// The number that a half-edge gets if its triangle is turned over.
inline std::uint32_t turned_over(std::uint32_t h)
{
    return h - h % 3 + (2 - h % 3);
}

/// Pairs the half-edges if every edge has two triangles at most, and these run along it in opposite directions. Then no
/// triangle repeats another, and link_surface() has nothing to decide. Otherwise returns false, and `opposite` is of no
/// use. `corners` holds three different points for each triangle, and `edges` their edges. O(n).
bool link_plainly(std::span<const Triangle> corners, HalfedgesByEdge& edges, Buffer<std::uint32_t>& opposite);

/// A surface that link_plainly() has linked.
LinkedSurface plain_surface(Buffer<Triangle> corners, Buffer<std::uint32_t> opposite);

/// Finds each triangle's neighbours. Edges with two triangles join them into patches. The smaller part of a patch is
/// turned over so that the patch has one orientation; a patch without one (a Moebius strip) is cut open. If an edge of
/// an even number of triangles, more than two, is still not balanced, patches are turned over as find_turned_sheets()
/// says. Where more than two triangles meet, they are sorted around the edge and paired so that two bound the same
/// wedge of solid; a half-edge without a partner becomes boundary. Triangles that coincide are never neighbours. Once
/// patches are oriented, as many half-edges of an edge stay without a partner as more run along it one way than the
/// other. `corners` holds three different points for each triangle, and `edges` their edges; `positions` belong to the
/// points. `resolved` receives the edges of more than two triangles. O(n) plus sorting at each such edge.
LinkedSurface link_surface(Buffer<Triangle> corners, HalfedgesByEdge& edges, std::span<const glm::vec3> positions,
                           std::vector<NonmanifoldEdge>& resolved);

/// The number of half-edges that link_surface() leaves without a neighbour, which does not depend on positions.
/// `corners` holds three different points for each triangle, all below `point_count`. O(n) for bounded valence, O(n log
/// n) otherwise.
std::uint64_t count_open_edges(Buffer<Triangle> corners, std::uint32_t point_count);

}  // namespace kerf::core
