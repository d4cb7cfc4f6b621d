#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/cut_geometry.h"
#include "common/plane.h"
#include "common/ray_crossing.h"

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

/// How often, counted with sign, the ray leaves part `part`: +1 for each crossing from behind a triangle to its front,
/// -1 for the other way round. ray_crossing() gives the term of one triangle. The ray points away from the plane, so
/// that caps of this cut do not matter.
using CountCrossings = std::function<int(std::uint32_t part, const AxisRay& ray)>;

/// Groups the parts of one side into pieces. Returns for each part the number of its piece; pieces are numbered in the
/// order of their first part.
///
/// A solid that is not cut stays one piece. In a solid that is cut, a hole (clockwise loop) joins the smallest outer
/// loop around it; a whole shell of negative volume joins the piece it lies in; a whole shell of positive volume is a
/// piece of its own. A hole lies in an outer loop if the middle of its inside does, measured on three lines: loops may
/// touch and share points and edges. O(p + e log e) for p parts and e loop points, without a quadratic step for many
/// loops, side by side or nested; crossing counts are asked for whole cavities only, and only where a solid has come
/// apart.
std::vector<std::uint32_t> group_pieces(const Plane& plane, Side side, std::span<const SurfacePart> parts,
                                        std::span<const PartLoop> loops, const CountCrossings& count_crossings);

}  // namespace kerf
