#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "common/caps/outline_loops.h"
#include "common/geometry/ray_crossing.h"
#include "common/mesh/plane.h"
#include "common/mesh/side.h"

// Which parts of the sides of a cut are one piece: docs/cutting-rules.md, "Pieces". One function decides it for both
// back ends; they differ in how they find its input. The input is the same for both up to the order, and the result
// does not depend on the order, nor on where loops begin, nor on how a cap is triangulated.

namespace kerf::core {

/// A part of one side's surface: triangles that are connected by edges, without caps of this cut.
struct SurfacePart
{
    std::uint32_t solid = 0;  ///< TriangleGroup::solid of its triangles
    bool is_cut = false;      ///< an edge of the outline bounds it; otherwise it is a whole shell
    bool is_flat = false;     ///< cut: no vertex beyond the noise of the plane; whole: no volume to speak of
    glm::vec3 sample{0.0f};   ///< whole shells: ShellSample::point()
    double volume6 = 0.0;     ///< whole shells: MassMoments::volume6; negative for a cavity
};

/// A sample point of a shell that does not depend on the order of its triangles: the middle of the first one by the x,
/// y, z of its corners. A corner would do, but a ray from it runs along the faces that meet there, caps of earlier cuts
/// among them, and must be tested against all their triangles.
class ShellSample
{
public:
    void add(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c);
    /// The first corner so far; triangles that lie behind it need not be added.
    const glm::vec3& first_corner() const { return first_[0]; }
    glm::vec3 point() const;

private:
    std::array<glm::vec3, 3> first_{glm::vec3(std::numeric_limits<float>::infinity()), {}, {}};
};

/// Calls add(part, ray, term) for each crossing of a ray with a triangle of a wanted part; `term` is that of
/// ray_crossing(), +1 from behind a triangle to its front, -1 the other way round. It gets all rays at once; they point
/// away from the plane in one direction, so caps of this cut do not matter.
using AddCrossing = std::function<void(std::uint32_t part, std::uint32_t ray, int term)>;
using CountCrossings =
    std::function<void(std::span<const AxisRay> rays, const std::vector<bool>& is_wanted, const AddCrossing& add)>;

/// The parts on one side.
struct SideParts
{
    std::span<const SurfacePart> parts;
    CountCrossings count_crossings;
};

/// Groups the parts of both sides into pieces. Returns for each part the number of its piece on its side; pieces are
/// numbered in the order of their first part.
///
/// A solid that is not cut stays one piece. In a solid that is cut, a hole (clockwise loop) joins the smallest outer
/// loop around it; a flat part joins the first piece that is not flat; a whole shell of negative volume joins the piece
/// it lies in; a whole shell of positive volume is a piece of its own. A hole lies in an outer loop if at least two of
/// three interior sample points do: loops may touch and share points and edges. If the outline cannot be divided into
/// loops that keep to one piece on either side, the pieces that meet there become one.
///
/// O(p) for p parts if each solid is in one part; otherwise O(p + e log e) for e outline edges, without a quadratic
/// step for many loops, side by side or nested. Crossings are counted once per side, for whole cavities only, and only
/// if a solid has come apart; each one found costs O(log).
BySide<std::vector<std::uint32_t>> group_pieces(const Plane& plane, const BySide<SideParts>& sides,
                                                std::span<const glm::vec3> points,
                                                std::span<const OutlineEdge> outline);

}  // namespace kerf::core
