#include "halfedge/cut/edges_in_plane.h"

#include "common/cutting/cut_geometry.h"

namespace kerf::core::halfedge {

namespace {

Side side_of(const Plane& plane, const std::array<glm::vec3, 3>& p, const std::array<double, 3>& d)
{
    switch (classify(d[0], d[1], d[2])) {
        case TriangleClass::negative:
            return Side::negative;
        case TriangleClass::in_plane:
            return coplanar_side(plane, p[0], p[1], p[2]);
        case TriangleClass::positive:
        case TriangleClass::crossing:
            break;
    }
    return Side::positive;
}

}  // namespace

Side kept_side(const Universe& u, const Plane& plane, SlotId slot, const std::array<double, 3>& distance)
{
    const Triangle& t = u.slots[slot];
    const auto corner = [&](std::size_t i) { return u.vertices[t[i]].position; };
    return side_of(plane, {corner(0), corner(1), corner(2)}, distance);
}

Side kept_side(const Universe& u, const Plane& plane, FaceId face)
{
    std::array<glm::vec3, 3> p;
    std::array<double, 3> d;
    HalfedgeId h = u.mesh.halfedge_of(face);
    for (std::size_t i = 0; i < 3; ++i, h = u.mesh.next(h)) {
        p[i] = u.mesh.position(u.mesh.from(h));
        d[i] = plane.signed_distance(p[i]);
    }
    return side_of(plane, p, d);
}

}  // namespace kerf::core::halfedge
