#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "halfedge/cut/find.h"
#include "halfedge/cut/split.h"

// The section: what WALK makes of the crossing triangles. Outline edges, cut points, and loops of them.

namespace kerf::core::halfedge {

/// A closed loop of outline edges, or a chain that ends at boundary.
struct Loop
{
    std::size_t first = 0, count = 0;  ///< in `loop_edges` and `loop_points`: outline edge i starts at point i
    std::uint32_t solid = 0;
    Index shell = 0;    ///< of the cut shells
    Index cap_set = 0;  ///< loops of one set are closed together: they bound the same piece shells on both sides
    bool closed = true;
    glm::vec3 end{0.0f};  ///< chains: the end of the last outline edge
};

/// A crossed edge on the boundary of the mesh.
struct BoundaryCut
{
    HalfedgeId halfedge;  ///< the boundary half-edge
    CutPointId cut_point;
    PointId positive_end, negative_end;
};

/// An outline edge between classes of points that coincide.
struct ClassedEdge
{
    OutlineEdgeId id;
    Index from = 0, to = 0;  ///< in `outline_points`, as it runs in the surface of the positive side
};

/// The result of WALK: the section's outline as loops and chains. The plan of the pieces numbers the cap sets, and links
/// an irregular outline once more; CAP appends the points where loops cross, outline edges that cancel, and which
/// points are shared then. From STITCH on it is only read.
struct Section
{
    Coincidences coincidences;
    std::vector<glm::vec3> cut_points;  ///< position of each cut edge's point
    std::vector<BoundaryCut> boundary_cuts;
    std::size_t new_vertices = 0;  ///< written behind the universe's vertices so far
    /// Loop by loop, and behind them, once caps are planned, the points where loops cross: those are points of caps
    /// alone, each with an outline edge near by.
    std::vector<OutlineEdgeId> loop_edges;
    std::vector<glm::vec3> loop_points;
    std::vector<Loop> loops;
    std::vector<std::uint32_t> loops_on_shell;  ///< loops and chains, by cut shell

    // Irregular sections
    std::vector<ClassedEdge> outline;       ///< all outline edges that do not cancel
    std::vector<glm::vec3> outline_points;  ///< by class
    /// Pairs of outline edges that run forth and back over the same points; CAP adds to them.
    std::vector<std::array<OutlineEdgeId, 2>> cancelled;
    /// By cut point: more than one vertex may be there on a side, or it is one with others. What lies there finds its
    /// vertices by going around them; anywhere else a cut point is one vertex on each side.
    std::vector<std::uint8_t> cut_point_is_shared;
    bool any_shared = false;  ///< some point of the outline is shared

    void reserve(std::size_t crossings_expected);
    void clear();

    const glm::vec3& position_of(CutPointId cut_point) const { return cut_points[cut_point.number()]; }

    bool is_irregular() const { return coincidences.irregular; }

    /// Each curve that the surface is cut along is a loop or chain of the outline. Not so where a curve shrinks to a
    /// point (a thin neck) or to a path run forth and back (a thin sheet), or falls apart at the boundary.
    bool loops_are_all_curves() const
    {
        return !coincidences.collapsed && !coincidences.meets_boundary && cancelled.empty();
    }

    void clear_loops()
    {
        loops.clear();
        loop_edges.clear();
        loop_points.clear();
    }

    /// Says of point p of the outline that it is shared.
    void share_point(const Found& found, std::size_t p)
    {
        any_shared = true;
        const OutlineEdgeId edge = loop_edges[p];
        if (found.is_crossing(edge) && found.crossing(edge).entry_cut_point.is_valid())
            cut_point_is_shared[found.crossing(edge).entry_cut_point.number()] = 1;
    }
    /// The same of both ends of an outline edge.
    void share_ends(const Found& found, OutlineEdgeId edge)
    {
        any_shared = true;
        if (!found.is_crossing(edge)) return;
        for (const CutPointId cut_point : {found.crossing(edge).entry_cut_point, found.crossing(edge).exit_cut_point})
            if (cut_point.is_valid()) cut_point_is_shared[cut_point.number()] = 1;
    }
    bool is_shared(CutPointId cut_point) const
    {
        return !cut_point.is_valid() || cut_point_is_shared[cut_point.number()] != 0;
    }
    /// Whether a corner of a crossing triangle's sub-triangles may be at a shared point.
    bool is_shared(const Crossing& c) const
    {
        return c.split.next_code != TriangleSplit::kCutNext || c.split.previous_code != TriangleSplit::kCutPrevious ||
               is_shared(c.entry_cut_point) || is_shared(c.exit_cut_point);
    }
};

/// Signed area of the closed loops, mesh units squared: positive where they run counter-clockwise around the normal.
/// O(k).
double section_area(const Plane& plane, const Section& section);

/// Length of the closed loops, mesh units. O(k).
double section_length(const Section& section);

}  // namespace kerf::core::halfedge
