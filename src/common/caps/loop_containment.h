#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "common/geometry/containment.h"
#include "common/geometry/line_hits.h"
#include "common/geometry/ray_crossing.h"

namespace kerf::core {

/// A closed loop in a plane; the last point is not repeated.
using PlanarLoop = std::span<const PlanarPoint>;

/// Calls visit(p, q) for each edge of a loop.
template <class Visit>
void for_each_edge(PlanarLoop loop, Visit&& visit)
{
    for (std::size_t i = 0; i < loop.size(); ++i) visit(loop[i], loop[i + 1 < loop.size() ? i + 1 : 0]);
}

/// Twice the signed area of a loop with this box: the same bits wherever the loop begins. About a corner of the box, so that
/// a loop far from the origin loses no digits.
double twice_area(PlanarLoop loop, const Box& box);

/// Whether loops of one section, all projected alike, lie in one another: a loop does if at least two of three sample
/// points of its inside do. They lie where no point of the loop is near, because loops may touch one another in points
/// and edges. Keeps its memory.
class LoopContainment
{
public:
    /// Begins anew, with loops that live as long as it is asked.
    void begin(std::span<const PlanarLoop> loops);

    /// Decides which of `candidates`, numbers of loops, lie in loop `outer`; `lies_in` has a place for each. O(e log c)
    /// for e edges of the outer loop and c candidates; O(f log f) once for each candidate of f edges.
    void decide(std::uint32_t outer, std::span<const std::uint32_t> candidates, std::span<std::uint8_t> lies_in);

private:
    static constexpr std::size_t kSamples = 3;  ///< odd, so that they always have a majority

    std::span<const glm::vec3> samples_of(std::uint32_t loop);
    void choose_samples(PlanarLoop loop);
    bool middle_at(PlanarLoop loop, float v, glm::vec3& middle);

    std::span<const PlanarLoop> loops_;
    std::vector<std::uint32_t> first_sample_;  ///< of each loop in chosen_, once it was a candidate
    std::vector<glm::vec3> chosen_;            ///< kSamples of a loop
    std::vector<WindingSample> asked_;
    WindingNumbers windings_;
    std::vector<float> heights_;
    std::vector<LineHit> hits_;
};

}  // namespace kerf::core
