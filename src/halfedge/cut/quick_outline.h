#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "common/caps/outline_loops.h"
#include "common/cutting/plane_section.h"
#include "common/geometry/disjoint_sets.h"
#include "common/mesh/plane.h"
#include "halfedge/cut/crossing_numbers.h"
#include "halfedge/cut/leaf_distances.h"
#include "halfedge/cut/leaf_prefetch.h"
#include "halfedge/cut/visit_leaves.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// The outline of a section that meets no hole, whatever lies on the plane: each edge of it begins where others end, on the
/// edge by which the outline leaves a triangle or, if that cut point is a corner, at this corner. One point an edge, and
/// nothing of what a cut needs besides. The points, edges and paths are those of FIND, SPLIT and WALK, bit for bit and in
/// their order.
class QuickOutline
{
public:
    /// Adds to a section that is clear. False if it meets a hole, if a cut point lies on the corner across from its edge, or
    /// if nothing may be left on a side; the section is clear then. It is known that the plane does not miss.
    /// O(s log(n / s) + k), and O(c log c) for c edges that begin or end at a corner. May throw std::bad_alloc.
    bool find(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane,
              PlaneSection& section);

private:
    static constexpr std::uint8_t kNoCorner = 3;

    /// An edge of the outline: it runs through a triangle that the plane crosses, or is an edge of the mesh in the plane.
    struct Edge
    {
        glm::vec3 end;  ///< where it ends
        /// Where the edge can't begin: the corner that is not at the edge by which it enters its triangle.
        glm::vec3 opposite;
        SlotId slot;  ///< the triangle; if it lies in the plane, the one that is kept on the negative side
        FaceId face;  ///< whose source it has
        GroupId group;
        Index next = kNone;  ///< the edge that begins where it ends; kNone if that is at a corner
        /// Where the edge of the triangle begins that it leaves by; kNoCorner: it leaves by a corner on the plane. If it
        /// lies in the plane: where its half-edge begins, which runs the other way.
        std::uint8_t exit_corner = kNoCorner;
        /// The corner of the triangle that its end is, though it leaves by an edge.
        std::uint8_t end_corner = kNoCorner;
        bool is_passed = false;  ///< by trace()
    };
    /// An edge that begins or ends at a corner.
    struct AtCorner
    {
        PointId corner;
        Index edge;
    };
    /// An edge that lies in the plane, before it has a number.
    struct InPlane
    {
        Edge edge;
        PointId start, end;
    };

    void clear();
    bool find_edges(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane,
                    PlaneSection& section);
    bool open_leaf(const Universe& universe, const Plane& plane, const Node& leaf, const VertexPrefetch& ahead);
    bool add_crossing(const Universe& universe, SlotId slot, Index triangle);
    bool add_crossing_at_corner(const Universe& universe, SlotId slot, Index triangle);
    static bool leave_by_edge(const Universe& universe, const Triangle& triangle, const std::array<double, 3>& distance,
                              std::uint8_t from, Edge& edge);
    void add_edges_in_plane(const Universe& universe, const Plane& plane, SlotId slot, Index triangle, GroupId group);
    bool find_next(const Universe& universe);
    bool trace(const Universe& universe, PlaneSection& section);
    bool list_outline(const Universe& universe);
    void unite(Index a, Index b, bool is_first);
    void take_representatives();
    void leave_out_pairs();
    bool divide(const Universe& universe, const Plane& plane, PlaneSection& section);
    void add_edge(const Universe& universe, Index number, PlaneSection& section);
    void add_ends(const Universe& universe, const Plane& plane, PlaneSection& section) const;

    std::vector<LeafVisit> visits_;
    std::vector<NodeId> leaves_;
    std::vector<Edge> edges_;   ///< crossing triangles in the order of the tree, then what lies in the plane
    std::size_t crossing_ = 0;  ///< how many of them are of crossing triangles
    std::vector<InPlane> in_plane_;
    std::vector<AtCorner> beginning_, ending_;
    BySide<bool> keeps_triangles_{};   ///< in the leaves, beside those that cross
    std::size_t ends_at_corners_ = 0;  ///< how many edges end at a corner though they leave by an edge
    std::vector<Index> traced_;        ///< edges in the section's order, if the ends are asked for
    FaceTable numbers_;
    LeafDistances distances_;

    // If points coincide: the outline by its points, which are the ends of edges, then corners.
    std::vector<PointId> corners_;
    std::vector<glm::vec3> points_;
    std::vector<OutlineEdge> outline_;
    std::vector<Index> number_;  ///< of an edge of the outline, among all
    std::vector<std::uint64_t> solids_;
    DisjointSets classes_{0};  ///< of points
    OppositeEdges opposite_;
    OutlineDivider divider_;
};

}  // namespace kerf::core::halfedge
