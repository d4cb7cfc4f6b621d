#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"
#include "common/mesh/side.h"

// How the outline of a section is divided into loops and chains, for both back ends: docs/cutting-rules.md, "Loops and
// chains". The result depends on the positions of the outline's points and on the triangles that its edges lie in, not
// on the order in which a back end finds them.

namespace kerf::core {

/// Stands for no part: nothing is left of an edge's triangle on that side (OutlineEdge::part).
inline constexpr std::uint32_t kNoPart = 0xFFFFFFFFu;

/// An edge of a section, as it runs in the surface of the positive side.
struct OutlineEdge
{
    std::uint32_t from = 0, to = 0;    ///< numbers of points
    BySide<std::uint32_t> part{};      ///< the part that it bounds on each side, or kNoPart
    std::uint32_t source = kNoSource;  ///< IndexedMesh::sources of the triangle that it lies in; the smaller of two
};

/// A loop or chain: a run of DividedOutline::edges.
struct OutlinePath
{
    std::size_t first = 0, count = 0;
    bool closed = true;  ///< false: a chain, which ends at the boundary of an open mesh
};

/// An outline taken apart. Each edge is on one path.
struct DividedOutline
{
    std::vector<std::uint32_t> edges;  ///< numbers of edges, path by path; each starts where the one before ends
    std::vector<OutlinePath> paths;
};

/// Pairs of edges that run forth and back between two points, as many as there are; each edge is in one pair at most.
/// O(e), and O(d log d) for the d edges at points that several edges leave.
std::vector<std::array<std::uint32_t, 2>> opposite_edges(std::size_t point_count, std::span<const OutlineEdge> edges);

/// Divides an outline into simple loops and chains: no path visits a point twice. Only edges of one tag follow one
/// another; without tags any may.
///
/// At a point where one edge arrives and one of the same tag leaves there is no choice. Elsewhere the edges that leave
/// are put in order by where they lead (x, y, z), and those that lead to one place by their sources. A path always
/// takes the first that is left; a loop between two visits of a point leaves the path. First come the chains, from the
/// points that more edges leave than arrive at, in the order of their positions; at one position, in the order of the
/// edges there. Then comes the rest, from the same points in the same order. An outline is always followed as seen with
/// the normal's longest component positive, so that a flipped plane divides it alike.
///
/// Loops without a choice come in the order of their first edges, and begin with them. O(e + d log d) for d edges at
/// points with a choice.
DividedOutline divide_outline(const Plane& plane, std::span<const glm::vec3> points, std::span<const OutlineEdge> edges,
                              std::span<const std::uint64_t> tags = {});

}  // namespace kerf::core
