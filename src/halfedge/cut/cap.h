#pragma once

#include "common/caps/cap_triangulator.h"
#include "common/caps/run_boxes.h"
#include "halfedge/cut/cut_plan.h"

namespace kerf::halfedge {

/// CAP: closes the loops of a section, set by set.
class CapPlanner
{
public:
    CapPlanner();

    /// Fills `caps`, `cap_sets`, `cap_order` and, where outline edges cancel, `cancelled` from the closed loops in
    /// `scratch`; where loops cross, points are appended to `loop_points`. O(k) for one convex loop, otherwise O(k log
    /// k). May throw std::bad_alloc.
    void plan(const Plane& plane, CutScratch& scratch);

    /// By how much the caps of the last plan(), each triangle counted positive, have more area than the section; mesh
    /// units squared. 0 but where the outline winds backwards or could not be untangled, and for rounding.
    double excess() const { return excess_; }

    /// What triangulating took in the last plan(): see CutStatistics::cap_steps.
    std::uint64_t steps() const { return mesh_.steps; }

private:
    void close_set(std::span<const std::size_t> loops, Index set, CutScratch& scratch);
    /// Appends a loop to the outline. Points that only differ along the dropped axis fall on one another: a triangle of
    /// no projected area takes the first of the two away. False, and nothing is appended, when less than three are
    /// left.
    bool append_loop(const Loop& loop, CutScratch& scratch);
    void append_point(std::size_t p, const CutScratch& scratch);
    void drop_point();
    void clear_outline();
    /// Covers the outline, unless it is empty, in the first way that can.
    void close_outline(CutScratch& scratch);
    /// Appends `mesh_` to the caps.
    void take_over(CutScratch& scratch);
    /// Area of the triangles in `mesh_` that are turned over, in the projection.
    double turned_area(const CutScratch& scratch) const;
    /// Joins two edges: of cap triangles, or outline edges.
    static void connect(CapLink a, CapLink b, CutScratch& scratch);
    void order_spatially(const CapSet& cap, CutScratch& scratch);
    glm::dvec2 projected(const glm::vec3& p) const { return {p[axis_u_], p[axis_v_]}; }

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

/// Signed area of the closed loops, mesh units squared: positive where they run counter-clockwise around the normal.
double section_area(const Plane& plane, const CutScratch& scratch);

/// Length of the closed loops, mesh units. O(k).
double section_length(const CutScratch& scratch);

}  // namespace kerf::halfedge
