#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "common/caps/cap_quality.h"
#include "common/caps/cap_triangulator.h"
#include "common/caps/loop_boxes.h"
#include "common/mesh/plane.h"

// Closes whole sections, for every back end that has right caps.

namespace kerf::core {

/// A closed loop of a section: a run of its points. Edge i of the section runs from point i to the next of its loop.
struct CapLoop
{
    std::size_t first = 0, count = 0;
    Index set = 0;  ///< loops of one set are closed together: outer loops with their holes
};

/// The caps of one set of loops.
struct CapSet
{
    Index set = 0;
    std::size_t first = 0, count = 0;  ///< triangles
};

/// The triangles that close a section, each for both sides.
struct SectionCaps
{
    /// Corners are points of the section, counter-clockwise seen from the positive side; links to the outline name its
    /// edges by the points where they start.
    std::vector<CapTriangle> triangles;
    std::vector<CapSet> sets;
    std::vector<Index> order;  ///< of the triangles, spatially coherent within a set
    /// Of each point where loops cross, which close() appends to the points: an edge near by. Such points are corners
    /// of caps alone.
    std::vector<Index> crossing_edges;
    std::vector<std::array<Index, 2>> cancelled;  ///< edges that run forth and back over the same two places
    /// Points whose corners bear the number of another point in the same place, or do not hang together: only the links
    /// tell what a corner belongs to.
    std::vector<Index> shared_points;

    void clear()
    {
        triangles.clear();
        sets.clear();
        order.clear();
        crossing_edges.clear();
        cancelled.clear();
        shared_points.clear();
    }
};

/// Closes the loops of a section, set by set, each in the first way that can: see cap_triangulator.h, or, if a Delaunay
/// triangulation is asked for, by that. Keeps its memory from section to section.
class SectionCloser
{
public:
    SectionCloser();

    /// Covers closed loops. Appends to `points` where loops cross. `caps` must be clear. O(k) for one convex loop,
    /// otherwise O(k log k). May throw std::bad_alloc.
    void close(const Plane& plane, std::span<const CapLoop> loops, CapQuality quality, std::vector<glm::vec3>& points,
               SectionCaps& caps);

    /// The area of the caps of the last close(), each triangle counted positive, less that of the section; mesh units
    /// squared. Apart from rounding it is 0 unless the outline winds backwards or could not be untangled.
    double excess() const { return excess_; }

    /// The cost of the last close(): see CutStatistics::cap_steps.
    std::uint64_t steps() const { return mesh_.steps; }

private:
    enum Way : std::uint8_t
    {
        convex,
        clipping,
        nested,
        constrained,
        untangling,
        topological,
    };

    /// The ways in the order in which they are tried; the last closes all.
    static std::span<const Way> ways_of(CapQuality quality);

    void close_set(std::span<const std::size_t> loops, Index set);
    /// Appends a loop to the outline. Points that differ only along the dropped axis coincide: a triangle without
    /// projected area takes the first of the two away. Returns false and appends nothing if fewer than three are left.
    bool append_loop(const CapLoop& loop);
    void append_point(std::size_t p);
    void drop_point();
    void clear_outline();
    /// Covers the outline, unless it is empty, in the first way that can.
    void close_outline();
    /// Appends `mesh_` to the caps.
    void take_over();
    /// Counts points as shared if two triangles, or a triangle and the outline, name one end of the edge between them by
    /// them: that they lie in one place does not make them one.
    void share_ends_of_links(const CapOutline& outline);
    /// Area of the triangles in `mesh_` that are turned over, in the projection.
    double turned_area() const;
    /// Joins two edges: of cap triangles, or outline edges.
    void connect(CapLink a, CapLink b);
    void order_spatially(const CapSet& cap);
    /// Sorts `keys_`, which are in the order of their triangles.
    void sort_by_counting();
    glm::dvec2 projected(const glm::vec3& p) const { return {p[axis_u_], p[axis_v_]}; }
    const std::vector<glm::vec3>& section_points() const { return *points_in_; }

    // Of the section that is being closed
    std::span<const CapLoop> loops_;
    std::vector<glm::vec3>* points_in_ = nullptr;
    SectionCaps* caps_ = nullptr;
    std::vector<std::size_t> by_set_;  ///< the loops, those of one set one after the other

    std::array<std::unique_ptr<CapTriangulator>, 6> ways_;  ///< by Way
    CapQuality quality_ = CapQuality::fast;
    int axis_u_ = 0, axis_v_ = 1;       ///< coordinates that are kept; (u, v, plane normal) is right-handed
    std::vector<std::size_t> upright_;  ///< loops that vanish when they are projected
    std::vector<glm::dvec2> points_;
    std::vector<glm::vec3> positions_;
    std::vector<Index> starts_;
    std::vector<Index> global_;     ///< point of the section of each local point
    std::vector<Index> successor_;  ///< of each local point in its loop, if share_ends_of_links() was called
    std::vector<CapLink> edge_;     ///< what leaves each local point: the outline edge of a point, or an edge of a cap
    Box2 box_;                      ///< of the set's points
    CapMesh mesh_;
    double excess_ = 0.0;
    std::vector<std::pair<std::uint32_t, Index>> keys_, sorted_;
};

}  // namespace kerf::core
