#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "common/cutting/plane_section.h"
#include "common/mesh/plane.h"
#include "halfedge/cut/crossing_numbers.h"
#include "halfedge/cut/leaf_distances.h"
#include "halfedge/cut/leaf_prefetch.h"
#include "halfedge/cut/visit_leaves.h"
#include "halfedge/universe/universe.h"

namespace kerf::core::halfedge {

/// The outline of a section in which nothing coincides, which nearly all are: no corner lies on the plane, no cut point
/// on a corner or on another one, and the mesh has no hole there. Then each crossing triangle has one edge that the
/// outline leaves it by, and the triangle beyond is the next: one cut point a triangle, and nothing of what a cut needs
/// besides. The points, edges and paths are those of FIND, SPLIT and WALK, bit for bit and in their order.
class QuickOutline
{
public:
    /// Adds to a section that is clear; false if something coincides, and the section is clear then. It is known that the
    /// plane does not miss. O(s log(n / s) + k). May throw std::bad_alloc.
    bool find(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane,
              PlaneSection& section);

private:
    /// A triangle that the plane crosses.
    struct Crossed
    {
        glm::vec3 exit;      ///< where the outline leaves it: on the edge from the negative to the positive corner
        glm::vec3 opposite;  ///< the corner that is not at the edge by which the outline enters it
        SlotId slot;
        FaceId face;
        GroupId group;
        Index exit_corner = 0;  ///< where the edge begins that it leaves by: 0 to 2
        Index next = kNone;     ///< the triangle beyond it; kNone once the outline has passed
    };

    bool find_crossed(const Universe& universe, const std::vector<ShellRoot>& shells, const Plane& plane,
                      PlaneSection& section);
    bool open_leaf(const Universe& universe, const Plane& plane, const Node& leaf, const VertexPrefetch& ahead);
    bool find_next(const Universe& universe);
    bool trace(const Universe& universe, PlaneSection& section);
    void add_ends(const Universe& universe, const Plane& plane, PlaneSection& section) const;

    std::vector<LeafVisit> visits_;
    std::vector<NodeId> leaves_;
    std::vector<Crossed> crossed_;
    std::vector<SlotId> traced_;  ///< the triangle of each edge, if the ends are asked for
    FaceTable numbers_;
    LeafDistances distances_;
};

}  // namespace kerf::core::halfedge
