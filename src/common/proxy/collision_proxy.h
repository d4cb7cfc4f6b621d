#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "common/cutting/cut.h"
#include "common/mesh/box.h"
#include "common/mesh/indexed_mesh.h"
#include "common/mesh/support_points.h"

namespace kerf::core {

/// The shapes that can stand for a fragment in the physics engine.
enum class ProxyKind : std::uint8_t
{
    box,     ///< axis-aligned box
    sphere,  ///< a sphere around all vertices: box centre, farthest vertex; at most sqrt(3) times the smallest one
    bounded_hull,  ///< the vertices that are extreme along kSupportDirections fixed directions, for their convex hull
    full_hull,     ///< convex hull of all vertices
    points,        ///< points whose hull is left to the physics engine: some program makes them
};
std::string_view name_of(ProxyKind kind);

/// A convex body in mesh coordinates.
struct CollisionProxy
{
    ProxyKind kind = ProxyKind::box;
    Box box;                 ///< bounds of the vertices; every kind
    glm::vec3 centre{0.0f};  ///< sphere: its centre
    float radius = 0.0f;     ///< sphere: its radius; at most the largest float, so vertices near it may lie outside
    std::vector<glm::vec3> points;  ///< hulls: vertices of the mesh at different places; of a full hull its corners
    std::vector<Triangle> faces;    ///< full_hull: its triangles, counter-clockwise seen from outside; empty if the
                                    ///< points are coplanar. Those of a bounded hull are its hull_faces().
};

/// The bounded hull over support points that were found elsewhere (a tree keeps them): each place once, in the order of
/// the directions. Inside the full hull. Its share of the full hull's volume is 100 % for a box, 96 % for a cylinder
/// along an axis, about 87 % for an asteroid, 82 % for a sphere and 81 % for a torus. O(1).
CollisionProxy bounded_hull(const Box& box, const std::array<glm::vec3, kSupportDirections>& points);

/// The triangles of the convex hull of some points, counter-clockwise seen from outside; none if they are coplanar.
/// Points that are not corners of the hull are in no triangle. O(points log(points)).
std::vector<Triangle> hull_faces(std::span<const glm::vec3> points);

/// The proxy of a set of vertices. Empty for no vertices, for `points` and for a kind that does not exist; hulls leave
/// out vertices that are not finite. O(n), full_hull O(n log n).
CollisionProxy collision_proxy(ProxyKind kind, std::span<const Vertex> vertices);

/// The same of the vertices that an object uses. `bounded_hull` costs what Cuttable::support_points() costs, `box`
/// O(1).
CollisionProxy collision_proxy(const Cuttable& object, ProxyKind kind);

}  // namespace kerf::core
