#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <span>
#include <vector>

#include "halfedge/cut_plan.h"

namespace kerf::halfedge {

/// Loops that are closed together, projected along a coordinate axis, which is exact: coordinates are those of the
/// mesh. Outer loops run counter-clockwise. Seam i runs from point i to the next point of its loop.
struct CapOutline
{
    std::span<const glm::dvec2> points;
    std::span<const glm::vec3> positions;  ///< the same points in space: those that are one point are equal there too
    std::span<const Index> loop_starts;    ///< first point of each loop, and the number of points at the end
    int axis_u = 0, axis_v = 1;            ///< which coordinates in space those in the projection are

    Index successor(Index i, Index loop) const { return i + 1 == loop_starts[loop + 1] ? loop_starts[loop] : i + 1; }
};

/// A point in the plane where edges of an outline cross: no point of the surface, but a corner of cap triangles.
struct CrossingPoint
{
    glm::vec3 position;
    Index seam;  ///< of one of the edges
};

/// Triangles over an outline. Corners are points of it, links are as in CapTriangle, by local numbers.
struct CapMesh
{
    std::vector<CapTriangle> triangles;
    /// Numbered as corners behind the points of the outline.
    std::vector<CrossingPoint> crossing_points;
    /// Seams that run forth and back over the same edge with no cap between them.
    std::vector<std::array<Index, 2>> cancelled;
    /// Points of which corners are named for another one at the same position, or that have corners which don't hang
    /// together: what a corner belongs to only its neighbours say.
    std::vector<Index> shared_points;
    /// Corners and edges looked at, and predicates of CGAL's, so far: a refusal counts, and clear() does not reset it.
    std::uint64_t steps = 0;

    void clear()
    {
        triangles.clear();
        crossing_points.clear();
        cancelled.clear();
        shared_points.clear();
    }
};

/// A way to close sections. It covers the section as often as the loops wind around it, uses all points and adds none
/// but crossing points. Every seam is linked by exactly one triangle, or cancelled.
class CapTriangulator
{
public:
    virtual ~CapTriangulator() = default;

    /// False when this way can't close the outline; `cap` is undefined then. May throw std::bad_alloc, nothing else.
    virtual bool triangulate(const CapOutline& outline, CapMesh& cap) = 0;
};

/// What edges run over, each from its start to its end.
struct EdgeRoutes
{
    std::vector<Index> points;        ///< numbers of places, those of `added` behind the others
    std::vector<std::size_t> starts;  ///< first of each edge, and the number of points at the end
    std::vector<glm::dvec2> added;    ///< where two edges cross
    std::uint64_t steps = 0;          ///< predicates, counted up
};

/// Finds where edges meet that may cross all over.
class RouteFinder
{
public:
    virtual ~RouteFinder() = default;

    /// Leads each edge over every place that lies in it, and over one more wherever it crosses another: rounded to
    /// double, which may lead it over others beside that, and back. What comes out meets in places alone. False where
    /// more than `most_added` are new or the routes have more than `most_points`, where two places are equal and where
    /// an edge ends at its start. May throw std::bad_alloc, nothing else. O((n + crossings) log n + points) expected.
    virtual bool find(std::span<const glm::dvec2> places, std::span<const std::array<Index, 2>> edges,
                      std::size_t most_added, std::size_t most_points, EdgeRoutes& routes) = 0;
};

/// By a constrained Delaunay triangulation (CGAL).
std::unique_ptr<RouteFinder> make_route_finder();

/// One strictly convex loop, by halving it again and again: no point meets more than 2 log2(k) triangles, and a line
/// crosses O(log k) of them. O(k).
std::unique_ptr<CapTriangulator> make_convex_triangulator();

/// One simple concave loop, by clipping ears in layers: as few triangles along a line as Delaunay's, at a fraction of
/// the cost. Refuses loops that have few ears at a time. O(k log k).
std::unique_ptr<CapTriangulator> make_clipping_triangulator();

/// Concave and nested loops: constrained Delaunay triangulation of spatially sorted points, then winding numbers by
/// flooding from outside (CGAL). Refuses outlines that cross or touch themselves inside an edge. O(k log k).
std::unique_ptr<CapTriangulator> make_constrained_triangulator();

/// Outlines that touch or cross themselves: an edge that meets a point, or crosses an edge beside it, is led over that
/// point by a triangle with (almost) no area; where edges cross in earnest, farther than rounding from their ends, both
/// are led over a new point. Then as the constrained triangulator. Covers what the outline winds around up to these
/// triangles. Refuses outlines that cross themselves all over. O((k + meetings) log k).
std::unique_ptr<CapTriangulator> make_untangling_triangulator();

/// Any outline at all: each loop is halved by its order alone, wherever its points lie. Triangles may overlap and be
/// turned over, but the cap is closed and its signed area is right. The last resort for self-intersecting input. O(k).
std::unique_ptr<CapTriangulator> make_topological_triangulator();

}  // namespace kerf::halfedge
