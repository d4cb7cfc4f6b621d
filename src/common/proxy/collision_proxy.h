#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "common/mesh/box.h"
#include "common/mesh/indexed_mesh.h"

namespace kerf {

/// The shapes that can stand for a fragment in the physics engine.
enum class ProxyKind : std::uint8_t
{
    box,     ///< axis-aligned box
    sphere,  ///< a sphere around all vertices: box centre, farthest vertex; at most sqrt(3) times the smallest one
    bounded_hull,  ///< convex hull of the vertices that are extreme along kSupportDirections fixed directions
    full_hull,     ///< convex hull of all vertices
    every_vertex,  ///< as in the report: every vertex added to the physics engine's hull shape, one by one; quadratic
};
std::string_view name_of(ProxyKind kind);

/// A convex body in mesh coordinates.
struct CollisionProxy
{
    ProxyKind kind = ProxyKind::box;
    Box box;                 ///< bounds of the vertices; every kind
    glm::vec3 centre{0.0f};  ///< sphere: its centre
    float radius = 0.0f;     ///< sphere: its radius; at most the largest float, so vertices near it may lie outside
    std::vector<glm::vec3>
        points;  ///< hulls: corner points, all of them vertices of the mesh; every_vertex: all vertices
    std::vector<Triangle> faces;  ///< full_hull and bounded_hull: the hull's triangles, counter-clockwise seen from
                                  ///< outside; empty if the points are coplanar
};

/// Number of directions of the bounded hull, hence the bound on its points.
inline constexpr std::size_t kSupportDirections = 32;

/// The fixed unit directions of the bounded hull: sixteen lines, then the same lines in the opposite direction, bit for
/// bit the negatives (i and i + 16 belong together). The first three are the axes. No direction in space is farther
/// than 24.6 degrees from one of them.
const std::array<glm::vec3, kSupportDirections>& support_directions();

/// dot(direction, p) in float. All searches for extreme vertices use this one order of operations, so that a maximum
/// found in a tree and one found in a loop are the same number. Infinite values (of coordinates beyond 2e38) are equal,
/// too.
inline float support_value(const glm::vec3& direction, const glm::vec3& p)
{
    return (direction.x * p.x + direction.y * p.y) + direction.z * p.z;
}

/// For each support direction the extreme vertex: largest support value; among equals the lexicographically smallest
/// position, so that the answer depends on the positions only and not on their order. The origin if there are no
/// vertices. O(vertices * kSupportDirections).
std::array<glm::vec3, kSupportDirections> support_points(std::span<const Vertex> vertices);

/// The bounded hull over support points that were found elsewhere (a tree keeps them). Inside the full hull. Its share
/// of the full hull's volume is 100 % for a box, 96 % for a cylinder along an axis, about 87 % for an asteroid, 82 %
/// for a sphere and 81 % for a torus. O(1).
CollisionProxy bounded_hull(const Box& box, const std::array<glm::vec3, kSupportDirections>& points);

/// The proxy of a set of vertices. Empty for no vertices and for a kind that does not exist; hulls leave out vertices
/// that are not finite. O(n), full_hull O(n log n), every_vertex O(n^2).
CollisionProxy collision_proxy(ProxyKind kind, std::span<const Vertex> vertices);

}  // namespace kerf
