#pragma once

#include "common/caps/cap_triangulator.h"
#include "common/caps/loop_boxes.h"
#include "halfedge/cut/caps.h"
#include "halfedge/cut/section.h"

namespace kerf::halfedge {

/// CAP: closes the loops of a section, set by set.
class CapPlanner
{
public:
    CapPlanner();

    /// Covers the closed loops. Outline edges that cancel are appended to Section::cancelled, and points where loops
    /// cross to Section::loop_points. O(k) for one convex loop, otherwise O(k log k). May throw std::bad_alloc.
    void plan(const Plane& plane, const Found& found, Section& section, Caps& caps);

    /// The area of the caps of the last plan(), each triangle counted positive, less that of the section; mesh units
    /// squared. Apart from rounding it is 0 unless the outline winds backwards or could not be untangled.
    double excess() const { return excess_; }

    /// The cost of the last plan(): see CutStatistics::cap_steps.
    std::uint64_t steps() const { return mesh_.steps; }

private:
    void close_set(std::span<const std::size_t> loops, Index set);
    /// Appends a loop to the outline. Points that differ only along the dropped axis coincide: a triangle without
    /// projected area takes the first of the two away. Returns false and appends nothing if fewer than three are left.
    bool append_loop(const Loop& loop);
    void append_point(std::size_t p);
    void drop_point();
    void clear_outline();
    /// Covers the outline, unless it is empty, in the first way that can.
    void close_outline();
    /// Appends `mesh_` to the caps.
    void take_over();
    /// Area of the triangles in `mesh_` that are turned over, in the projection.
    double turned_area() const;
    /// Joins two edges: of cap triangles, or outline edges.
    void connect(CapLink a, CapLink b);
    void order_spatially(const CapSet& cap);
    glm::dvec2 projected(const glm::vec3& p) const { return {p[axis_u_], p[axis_v_]}; }

    // Of the plan that is being made
    const Found* found_ = nullptr;
    Section* section_ = nullptr;
    Caps* caps_ = nullptr;

    std::array<std::unique_ptr<CapTriangulator>, 4> ways_;  ///< in the order in which they are tried; the last can all
    int axis_u_ = 0, axis_v_ = 1;       ///< coordinates that are kept; (u, v, plane normal) is right-handed
    std::vector<std::size_t> upright_;  ///< loops that vanish when they are projected
    std::vector<glm::dvec2> points_;
    std::vector<glm::vec3> positions_;
    std::vector<Index> starts_;
    std::vector<Index> global_;  ///< point in `loop_points` of each local point
    std::vector<CapLink> edge_;  ///< what leaves each local point: the outline edge of a point, or an edge of a cap
    Box2 box_;                   ///< of the set's points
    CapMesh mesh_;
    double excess_ = 0.0;
    std::vector<std::pair<std::uint32_t, Index>> keys_, sorted_;
};

}  // namespace kerf::halfedge
