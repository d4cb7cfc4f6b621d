#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/cut_geometry.h"
#include "common/plane.h"

// Which parts of one side of a cut hang together. Two triangles belong together if they share an edge of the surface,
// or bound the same solid: their section loops are nested in one another, or one bounds a cavity inside the other. One
// function decides it for both back ends; they differ in how they find its input.

namespace kerf {

/// A part of one side's surface that is connected by edges, caps of this cut not counted.
struct SurfacePart
{
    std::uint32_t solid = 0;  ///< TriangleGroup::solid of its triangles
    bool is_cut = false;      ///< the section runs along it; otherwise it is a whole shell
    glm::vec3 sample{0.0f};   ///< whole shells: any of its vertices
    double volume6 = 0.0;     ///< whole shells: MassMoments::volume6; negative for a cavity
};

/// A closed loop of the section, as in SectionLoop: counter-clockwise around material seen from the positive side.
struct PartLoop
{
    std::uint32_t part = 0;  ///< index of the part that it bounds
    std::span<const glm::vec3> points;
};

/// An axis-parallel ray from a vertex.
struct AxisRay
{
    glm::vec3 origin;
    int axis = 0;           ///< 0, 1, 2 for x, y, z
    bool ascending = true;  ///< towards larger coordinates
};

/// How often, counted with sign, the ray leaves part `part`: +1 for each crossing from behind a triangle to its front,
/// -1 for the other way round. ray_crossing() gives the term of one triangle. The ray points away from the plane, so
/// that caps of this cut do not matter.
using CountCrossings = std::function<int(std::uint32_t part, const AxisRay& ray)>;

/// The term of one triangle in a signed crossing count: -1, 0 or +1. Edges and vertices are counted once between the
/// triangles that share them (half-open rule, edges evaluated in a canonical order), so a closed surface gives its
/// winding number.
int ray_crossing(const AxisRay& ray, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);

/// Groups the parts of one side into pieces. Returns for each part the number of its piece; pieces are numbered in the
/// order of their first part.
///
/// A solid that is not cut stays one piece. In a solid that is cut, a hole (clockwise loop) joins the smallest outer
/// loop around it; a whole shell of negative volume joins the piece it lies in; a whole shell of positive volume is a
/// piece of its own. O(p + e log e) for p parts and e loop points, without a quadratic step for many loops; crossing
/// counts are asked for whole cavities only.
std::vector<std::uint32_t> group_pieces(const Plane& plane, Side side, std::span<const SurfacePart> parts,
                                        std::span<const PartLoop> loops, const CountCrossings& count_crossings);

}  // namespace kerf
