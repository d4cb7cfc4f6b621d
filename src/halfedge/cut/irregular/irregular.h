#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/caps/outline_loops.h"
#include "halfedge/cut/irregular/coinciding_points.h"
#include "halfedge/cut/planned_pieces.h"
#include "halfedge/cut/section.h"
#include "halfedge/cut/stitch_plan.h"

// What only irregular sections need: those in which cut points coincide with vertices or with each other, edges lie in
// the plane, or outline edges cancel. The only header of this folder that the steps include; they call these functions
// in the order in which they stand here.

namespace kerf::core::halfedge {

// ----- WALK -----

/// Links irregular outlines. Keeps its memory.
class OutlineLinker
{
public:
    /// Links the outline if cut points coincide with vertices or with each other, or if edges lie in the plane. The
    /// points of the outline are classes of cut points and vertices that split_triangle() found to coincide,
    /// transitively. Outline edges whose ends are one point are dropped, and those that run back and forth between two
    /// points cancel. An OutlineDivider divides the rest into simple loops and chains, by solid. Fills `outline`,
    /// `outline_points`, `cancelled` and the loops. Expected O(k), and O(j log j) for the j outline edges at points
    /// where several meet.
    void link(const Universe& universe, const Plane& plane, const Found& found, Section& section);

    /// Divides the outline that link() found once more: only outline edges between the same two piece shells follow one
    /// another.
    void relink(const Universe& universe, const Plane& plane, const Found& found, const Pieces& pieces,
                Section& section);

private:
    void collect_edges(const Universe& universe, const Found& found, Section& section);
    void cancel_edges(const Universe& universe, const Found& found, Section& section);
    void divide(const Universe& universe, const Plane& plane, const Found& found, Section& section);

    CoincidingPoints classes_;
    std::vector<Index> members_;       ///< of each class
    std::vector<OutlineEdge> edges_;   ///< as common code takes them
    std::vector<std::uint64_t> tags_;  ///< of each outline edge
    std::vector<std::uint8_t> is_gone_;
    OppositeEdges opposite_;
    OutlineDivider divider_;
};

// ----- pieces -----

/// Targets of one side that have triangles at the same two points, in pairs: more than two triangles can meet at an
/// edge where points coincide, and no half-edge leads from one to all others. O(k log k).
std::vector<std::array<TargetId, 2>> targets_that_share_edges(const Universe& universe, const Found& found,
                                                              const Section& section);

/// Marks the outline edges of an irregular outline at which a side keeps no triangle: all of theirs there has shrunk
/// away, and it lay at the boundary of an open mesh. O(k), and O(k log k) if a crossing triangle has lost the
/// sub-triangle at its outline edge.
void find_edges_that_bound_nothing(const Universe& universe, const Section& section, Found& found);

/// Fills `edges` with the outline edges of an irregular outline as common code takes them, but for the parts that they
/// bound. O(k).
void list_outline_edges(const Universe& universe, const Found& found, const Section& section,
                        std::vector<OutlineEdge>& edges);

// ----- STITCH -----

/// Gives each edge in the plane an edge on each side: the edge stays with the positive face, and the negative face gets
/// one of its own. O(1) for each.
void open_in_plane_edges(const Found& found, StitchPlan& plan, SurfaceMesh& mesh);

/// Takes out of the half-edge mesh what has no area: faces that split_triangle() lets vanish, and outline edges that
/// run forth and back. Their two remaining half-edges become opposite to each other. O(k).
void contract(const std::vector<std::array<OutlineEdgeId, 2>>& cancelled, StitchPlan& plan, SurfaceMesh& mesh);

/// Gives each vertex fan at a shared point one point of the half-edge mesh. A point in the plane falls apart if its
/// faces are divided between the sides or if several loops run through it; cut points that coincide become one. Every
/// such fan has a face that is a sub-triangle or a cap triangle, lies at an outline edge, or was glued. O(k log k),
/// plus the valence of the points in the plane.
void split_points(const Found& found, const Section& section, const Caps& caps, StitchPlan& plan, SurfaceMesh& mesh);

}  // namespace kerf::core::halfedge
