#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "common/mesh/triangle_soup.h"
#include "common/repair/mesh_facts.h"
#include "common/repair/proven_mesh.h"

// From a soup of triangles to a mesh that keeps its promises: the steps are listed at the top of repair.cpp.

namespace kerf::core {

/// What repair() changed. Nothing here moves a vertex.
struct Repairs
{
    std::uint64_t degenerate_triangles = 0;  ///< dropped: two corners at one position
    std::uint64_t duplicate_triangles = 0;   ///< dropped: same three points as an earlier one, in the same orientation
                                             ///< once triangles are turned back
    std::uint64_t coinciding_triangles = 0;  ///< the same, but kept: without them a closed edge would be open
    std::uint64_t nonmanifold_edges = 0;     ///< more than two triangles met there: cut open or paired up
    std::uint64_t nonmanifold_points = 0;    ///< several vertex fans met in one point: split into one point for each
    std::uint64_t flipped_triangles = 0;     ///< turned over to agree with their patch, or with the outside
    std::uint64_t unorientable_edges = 0;    ///< cut open because no orientation satisfies both sides (Moebius)
    std::uint64_t replaced_attributes = 0;   ///< vertices with a normal or uv that is not finite: the mean normal of
                                             ///< their triangles and uv (0, 0) instead

    bool none() const
    {
        return degenerate_triangles + duplicate_triangles + coinciding_triangles + nonmanifold_edges +
                   nonmanifold_points + flipped_triangles + unorientable_edges + replaced_attributes ==
               0;
    }
    /// One clause for each kind that occurred, for people: "3 degenerate triangles dropped, 2 points split".
    std::string describe() const;
};

/// A mesh ready for a back end, or the reason why there is none.
struct Repaired
{
    ProvenMesh mesh;  ///< with its adjacency; without triangles if there is an error
    MeshFacts facts;  ///< of the soup, as measure() finds them; all 0 unless there is a mesh and they were wanted
    Repairs repairs;
    std::string error;  ///< one sentence: no triangle, an index out of range, a coordinate that is not finite, ...
};

/// Whether repair() says what the soup was like. To measure it takes a sixth of the time.
enum class FactsWanted : std::uint8_t
{
    all,
    none,
};

/// Makes a mesh that back ends can cut: welds vertices of bit-equal position into points (once and for all: afterwards
/// connectivity is by id), drops degenerate and duplicate triangles, splits non-manifold edges and points, orients
/// patches, finds the solids, and groups triangles by material and solid in otherwise unchanged order.
///
/// A closed mesh - along each edge as many triangles run one way as the other - stays closed: duplicates are dropped
/// only if that opens nothing (find_faults()); the others stay, with points of their own. Triangles that face the wrong
/// way are turned back before that is decided, and where more than two triangles meet (find_turned_sheets()).
///
/// Orientation: a shell whose triangles agree keeps its orientation, unless it is an outermost shell of negative
/// volume: that one is flipped together with what it contains. `sources` are triangle numbers of the soup. O(n log n)
/// time, O(n) memory. Throws std::bad_alloc if memory runs out.
Repaired repair(TriangleSoup soup, FactsWanted facts_wanted = FactsWanted::all);

}  // namespace kerf::core
