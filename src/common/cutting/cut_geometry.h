#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "common/mesh/indexed_mesh.h"
#include "common/mesh/plane.h"
#include "common/mesh/position_order.h"
#include "common/mesh/side.h"

// The geometry of one cut triangle, shared by both back ends so that they agree bit for bit. docs/cutting-rules.md
// explains why the rules are as they are.

namespace kerf::core {

/// Where a triangle lies.
enum class TriangleClass : std::uint8_t
{
    negative,  ///< no vertex above the plane, at least one below
    positive,  ///< no vertex below, at least one above
    in_plane,  ///< all three exactly on the plane: coplanar_side() decides
    crossing,  ///< vertices strictly on both sides: split_triangle()
};

inline TriangleClass classify(double da, double db, double dc)
{
    const bool above = da > 0.0 || db > 0.0 || dc > 0.0;
    const bool below = da < 0.0 || db < 0.0 || dc < 0.0;
    if (above && below) return TriangleClass::crossing;
    if (above) return TriangleClass::positive;
    return below ? TriangleClass::negative : TriangleClass::in_plane;
}

/// The side of the solid that a triangle in the plane bounds: behind the triangle. A triangle of zero area, or one
/// whose normal is perpendicular to the plane's, goes to the side of larger x (then y, z), and stays there if the plane
/// is flipped. The result does not depend on the corner that comes first.
Side coplanar_side(const Plane& plane, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// The point where an edge meets the plane.
struct CutPoint
{
    glm::vec3 position;
    double t = 0.0;        ///< 0 at the lexicographically smaller end point, 1 at the other
    bool swapped = false;  ///< the second end point given is the lexicographically smaller one
};

/// Cuts the edge from `a` to `b`, whose signed distances da and db are on different sides. Both orders of the end
/// points, and both triangles at the edge, get the same bits: end points are ordered by position, not by index, so both
/// copies of a seam edge agree too. The point is A + t (B - A) in double with t = dA / (dA - dB), clamped to the end
/// points' box and rounded to float once; an end point at distance 0 is returned itself.
CutPoint cut_edge(const glm::vec3& a, double da, const glm::vec3& b, double db);

/// The attributes at a cut point of the edge from vertex `a` to vertex `b`, with the same t and the same order as the
/// position; the normal is renormalised. `a` and `b` are in the order in which cut_edge() got them.
Vertex interpolate(const CutPoint& point, const Vertex& a, const Vertex& b);

/// The same for a float stream: `width` values each.
void interpolate(const CutPoint& point, const float* a, const float* b, float* result, std::uint32_t width);

/// One of the triangles that a crossing triangle falls into. Its corners are codes (see TriangleSplit).
struct SubTriangle
{
    Side side;
    std::array<std::uint8_t, 3> corners;
};

/// How one crossing triangle falls apart. Corners are codes: 0, 1, 2 for the triangle's own; kCutNext for the cut point
/// on the edge from the lone corner to the next one, kCutPrevious for that on the edge from the previous corner to the
/// lone one.
///
///              lone                    On one side lies (lone, N, P), on the other the quadrilateral N, next,
///              /  \                    previous, P, divided by its shorter diagonal. Cut points that coincide bit for
///          N  /____\  P                bit with a corner, or with each other, are that corner, or N. Triangles without
///            /      \                  three different corners are not made.
///        next ------ previous
struct TriangleSplit
{
    static constexpr std::uint8_t kCutNext = 3, kCutPrevious = 4;

    std::uint8_t lone = 0;  ///< the corner that is alone on its side
    Side lone_side = Side::positive;
    CutPoint cut_next;                          ///< of the edge lone -> next, in this order
    CutPoint cut_previous;                      ///< of the edge previous -> lone, in this order
    std::uint8_t next_code = kCutNext;          ///< cut_next after coincidences: a corner, or kCutNext
    std::uint8_t previous_code = kCutPrevious;  ///< likewise: a corner, kCutNext or kCutPrevious
    std::uint8_t sub_triangle_count = 0;
    std::array<SubTriangle, 3> sub_triangle{};
    /// The triangles of the split, the one with the lone corner first.
    std::span<const SubTriangle> sub_triangles() const { return {sub_triangle.data(), sub_triangle_count}; }

    /// The directed section edge as it runs in the surface of the positive side (so a cap of the negative side contains
    /// it, and one of the positive side its reverse). There is no edge if both ends are the same code.
    std::uint8_t section_from = 0, section_to = 0;
    bool has_section_edge() const { return section_from != section_to; }
};

/// Splits a triangle with corners `p` and signed distances `d`, at least one of which is positive and one negative. The
/// result does not depend on which corner comes first, beyond the numbering of the corners.
TriangleSplit split_triangle(const std::array<glm::vec3, 3>& p, const std::array<double, 3>& d);

}  // namespace kerf::core
