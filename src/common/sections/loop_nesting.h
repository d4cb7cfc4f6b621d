#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/caps/loop_containment.h"
#include "common/cutting/plane_section.h"
#include "common/geometry/containment.h"
#include "common/mesh/plane.h"

namespace kerf::core {

/// Which loop of a section lies in which. Keeps its memory.
class LoopNesting
{
public:
    /// For each path of a section the number of the smallest loop that it lies in, or kNoContainer: a hole lies in an
    /// outer loop, and what stands in the hole lies in the hole. Loops of all solids are asked. Of loops that coincide,
    /// an outer one lies in a hole, and of two that are alike the later lies in the earlier. Chains lie in none. Valid
    /// until the next call. O(k log k) for k edges, unless the boxes of many loops lie in one another and the loops do
    /// not; O(paths) with fewer than two loops. May throw std::bad_alloc.
    std::span<const std::uint32_t> find(const Plane& plane, const PlaneSection& section);

private:
    void collect(const PlaneSection& section, bool holes);
    void flatten(const Plane& plane, const PlaneSection& section);

    std::vector<std::uint32_t> parents_;
    std::vector<std::uint32_t> loops_;  ///< numbers of paths: holes first
    std::vector<PlanarPoint> points_;   ///< as those of the section, seen along one axis
    std::vector<PlanarLoop> outlines_;
    std::vector<ContainableShape> shapes_;
    LoopContainment containment_;
    SmallestContainers search_;
};

}  // namespace kerf::core
