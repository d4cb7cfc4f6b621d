#include "halfedge/cut/stitch_plan.h"

namespace kerf::core::halfedge {

bool diagonal_from_n(const Crossing& c)
{
    const TriangleSplit& split = c.split;
    if (split.previous_code == c.next()) return false;
    if (split.next_code == c.previous()) return true;
    if (split.sub_triangle_count < 2) return true;
    const SubTriangle& first_far = split.sub_triangle[split.sub_triangle_count - 2u];
    return first_far.side == split.lone_side || first_far.corners[2] == c.previous();
}

std::array<SubFace, 3> StitchPlan::sub_faces(const Crossing& c, Index number) const
{
    const auto lone = static_cast<std::uint8_t>(c.lone()), next = static_cast<std::uint8_t>(c.next()),
               previous = static_cast<std::uint8_t>(c.previous());
    const std::uint8_t n = c.split.next_code, p = c.split.previous_code;
    const Side near = c.split.lone_side, far = opposite(near);
    const auto [f, g] = new_faces(number);
    const auto sub = [](FaceId face, Side side, std::uint8_t i, std::uint8_t j, std::uint8_t k) {
        return SubFace{face, i != j && j != k && k != i, side, {i, j, k}};
    };
    if (diagonal_from_n(c))
        return {sub(c.face, near, lone, n, p), sub(f, far, n, next, previous), sub(g, far, n, previous, p)};
    return {sub(c.face, near, lone, n, p), sub(f, far, n, next, p), sub(g, far, next, previous, p)};
}

}  // namespace kerf::core::halfedge
