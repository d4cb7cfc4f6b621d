#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/mesh/index.h"

// How a section is closed: an outline goes in; triangles come out, with links across each of their edges. Each way
// takes the outlines that it can. SectionCloser tries them in this order: one convex loop (convex_triangulator.h), one
// simple loop (clipping_triangulator.h), nested ones (nested_triangulator.h), crossing ones (untangling_triangulator.h,
// which needs constrained_triangulator.h, or without CGAL nested_triangulator.h again), and whatever is left
// (topological_triangulator.h).

namespace kerf::core {

/// The other side of a cap triangle's edge: an edge of another cap triangle, or an edge of the outline.
class CapLink
{
public:
    CapLink() = default;
    /// The edge of a cap triangle from a corner to the next one.
    static CapLink to_triangle(Index triangle, Index corner) { return CapLink(3 * triangle + corner); }
    static CapLink to_outline(Index edge) { return CapLink(kOutline + edge); }

    bool is_outline() const { return (number_ & kOutline) != 0; }
    Index outline_edge() const { return number_ - kOutline; }
    Index triangle() const { return number_ / 3; }
    Index corner() const { return number_ % 3; }
    /// A number among the edges of all triangles, three for each.
    Index edge() const { return number_; }

    bool operator==(const CapLink&) const = default;

private:
    static constexpr Index kOutline = Index(1) << 31;

    explicit CapLink(Index number) : number_(number) {}

    Index number_ = kNone;
};

/// A cap triangle, counter-clockwise as its outline. `link[i]` belongs to the edge from corner i to corner i + 1.
struct CapTriangle
{
    std::array<Index, 3> corner;
    std::array<CapLink, 3> link{};
};

/// Joins two edges. True if both belong to the outline: then no triangle records it.
inline bool connect(std::vector<CapTriangle>& triangles, CapLink a, CapLink b)
{
    if (!a.is_outline()) triangles[a.triangle()].link[a.corner()] = b;
    if (!b.is_outline()) triangles[b.triangle()].link[b.corner()] = a;
    return a.is_outline() && b.is_outline();
}

/// Loops that are closed together, projected along a coordinate axis. The projection is exact: coordinates are those of
/// the mesh. Outer loops run counter-clockwise. Edge i runs from point i to the next point of its loop.
struct CapOutline
{
    std::span<const glm::dvec2> points;
    std::span<const glm::vec3> positions;  ///< the same points in space: those that are one point are equal there too
    std::span<const Index> loop_starts;    ///< first point of each loop, and the number of points at the end
    int axis_u = 0, axis_v = 1;            ///< the coordinates in space that the projection keeps

    Index successor(Index i, Index loop) const { return i + 1 == loop_starts[loop + 1] ? loop_starts[loop] : i + 1; }
};

/// A point in the plane where edges of an outline cross: no point of the surface, but a corner of cap triangles.
struct CrossingPoint
{
    glm::vec3 position;
    Index edge;  ///< of the outline, one of those that cross
};

/// Triangles over an outline. Corners are points of it.
struct CapMesh
{
    std::vector<CapTriangle> triangles;
    /// Numbered as corners behind the points of the outline.
    std::vector<CrossingPoint> crossing_points;
    /// Edges of the outline that run forth and back over the same two points with no cap between them.
    std::vector<std::array<Index, 2>> cancelled;
    /// Points whose corners bear the number of another point at the same position, or do not hang together: only its
    /// neighbours tell what a corner belongs to.
    std::vector<Index> shared_points;
    /// A triangle may be turned over, though the way that made it turns none over but by rounding.
    bool turns_over = false;
    /// Corners and edges looked at, and CGAL's predicates, so far: a refusal counts, and clear() does not reset it.
    std::uint64_t steps = 0;

    void clear()
    {
        triangles.clear();
        crossing_points.clear();
        cancelled.clear();
        shared_points.clear();
        turns_over = false;
    }

    /// Joins two edges; they cancel if both belong to the outline.
    void connect(CapLink a, CapLink b)
    {
        if (core::connect(triangles, a, b)) cancelled.push_back({a.outline_edge(), b.outline_edge()});
    }
};

/// A way to close sections. It covers the section as often as the loops wind around it, uses all points, and adds only
/// crossing points. Every edge of the outline is linked by exactly one triangle, or cancelled.
class CapTriangulator
{
public:
    virtual ~CapTriangulator() = default;

    /// False if this way cannot close the outline; `cap` is undefined then. May throw std::bad_alloc, nothing else.
    virtual bool triangulate(const CapOutline& outline, CapMesh& cap) = 0;
};

}  // namespace kerf::core
