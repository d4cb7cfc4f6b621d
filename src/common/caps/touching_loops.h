#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/caps/cap_triangulator.h"
#include "common/geometry/pair_table.h"

namespace kerf::core {

/// Which edge of an outline follows which. Where loops touch in a point, or one touches itself, several corners share a
/// place, and the loops may run through one another there. They are joined anew, so that the inside of each corner is one
/// wedge: then loops touch, but do not cross. Two loops may become one by that, and one two; the edges stay as they are.
struct Succession
{
    std::vector<Index> after;  ///< for each edge the next one; edges have the numbers of the points that they leave
    /// Points where an edge is followed by one that leaves another point at the same position, and all others there.
    std::vector<Index> shared;
};

/// Parts or joins loops where they touch. Keeps its memory.
class LoopParter
{
public:
    /// Valid until the next call. Leaves a place as it is if the outline does not wind 0 and 1 times around it by turns,
    /// or if edges fall together. Expected O(k), and O(j log j) for j corners that share their place.
    const Succession& part(const CapOutline& outline);
    /// Succession::shared of the last call.
    const std::vector<Index>& shared() const { return succession_.shared; }

private:
    /// A piece of an edge at a place where it begins or ends.
    struct Ray
    {
        glm::dvec2 towards;  ///< the other end of the edge
        Index edge;
        bool is_outgoing;  ///< it begins here, and the inside is on its left
    };

    void begin(const CapOutline& outline);
    void find_crowded(const CapOutline& outline);
    void part_place(const CapOutline& outline, std::span<const Index> points);

    Succession succession_;
    std::vector<Index> before_, end_;  ///< the edge that leads to each point, and the point that each edge leads to
    PairTable place_of_;               ///< a point at each place
    std::vector<std::uint8_t> is_crowded_;
    std::vector<Index> crowded_;  ///< points that may share their place with others
    std::vector<Ray> rays_;
};

}  // namespace kerf::core
