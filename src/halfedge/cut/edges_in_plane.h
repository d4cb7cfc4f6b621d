#pragma once

#include <array>

#include "common/mesh/plane.h"
#include "common/mesh/side.h"
#include "halfedge/universe/universe.h"

// Faces that have corners on the plane without crossing it, and their edges that lie in it.

namespace kerf::core::halfedge {

/// The side that such a face is kept on. `distance` belongs to the corners of its slot.
Side kept_side(const Universe& universe, const Plane& plane, SlotId slot, const std::array<double, 3>& distance);
/// The same of a face whose distances are not at hand.
Side kept_side(const Universe& universe, const Plane& plane, FaceId face);

/// An edge in the plane, as one of its faces sees it.
struct EdgeInPlane
{
    HalfedgeId halfedge;  ///< of the face
    std::size_t corner;   ///< of the face's slot, where it starts
    FaceId across;        ///< not valid: a boundary
    bool is_flush;        ///< nothing lies across, or what does is kept on the same side: no edge of the outline
};

/// Visits the edges of a face that lie in the plane. `side` is the one that the face is kept on.
template <class Visit>
void for_each_edge_in_plane(const Universe& u, const Plane& plane, SlotId slot, Side side,
                            const std::array<double, 3>& distance, Visit visit)
{
    if ((distance[0] == 0.0) + (distance[1] == 0.0) + (distance[2] == 0.0) < 2) return;
    HalfedgeId h = u.mesh.halfedge_of(u.face_of_slot[slot]);
    for (std::size_t i = 0; i < 3; ++i, h = u.mesh.next(h)) {
        if (distance[i] != 0.0 || distance[(i + 1) % 3] != 0.0) continue;
        const FaceId across = u.mesh.face(opposite(h));
        visit(EdgeInPlane{h, i, across, !across.is_valid() || kept_side(u, plane, across) == side});
    }
}

}  // namespace kerf::core::halfedge
