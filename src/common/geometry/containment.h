#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <limits>
#include <span>
#include <vector>

#include "common/geometry/point_tree.h"
#include "common/mesh/box.h"

// Containment of closed shapes (shells, loops). Shells in space and loops in a plane (z = 0) share the search.

namespace kerf::core {

inline constexpr std::uint32_t kNoContainer = std::numeric_limits<std::uint32_t>::max();

/// Whether `inner` lies in `outer`; their faces may touch.
inline bool encloses(const Box& outer, const Box& inner)
{
    return outer.lo.x <= inner.lo.x && inner.hi.x <= outer.hi.x && outer.lo.y <= inner.lo.y &&
           inner.hi.y <= outer.hi.y && outer.lo.z <= inner.lo.z && inner.hi.z <= outer.hi.z;
}

/// A shape that may lie in another one or contain others.
struct ContainableShape
{
    Box box;
    double size = 0.0;        ///< volume or area, at least 0: a container is larger than its contents
    bool can_contain = true;  ///< may contain others
    bool can_lie_in = true;   ///< a container is wanted for it
};

/// Decides which of `candidates` lie in `container`; `lies_in` has a place for each, 0 on entry.
using DecideContainment = std::function<void(std::uint32_t container, std::span<const std::uint32_t> candidates,
                                             std::span<std::uint8_t> lies_in)>;

/// Finds for each of some shapes the smallest one that contains it. Keeps its memory.
class SmallestContainers
{
public:
    /// For each item its container, or kNoContainer; valid until the next call. Containers are tried from small to
    /// large, on the items in their box that have found none yet; of items of equal size, those with larger numbers may
    /// lie in the others. O(n log n), and one decision for each pair of a box and an item in it that is tried: O(n)
    /// pairs if nested boxes belong to nested items.
    std::span<const std::uint32_t> find(std::span<const ContainableShape> items, const DecideContainment& decide);

private:
    std::vector<std::uint32_t> container_, by_size_, rank_, candidates_;
    std::vector<std::uint8_t> lies_in_;
    std::vector<glm::vec3> corners_;
    PointTree waiting_;
};

/// The same, once.
std::vector<std::uint32_t> smallest_containers(std::span<const ContainableShape> items,
                                               const DecideContainment& decide);

/// A point to be tested, and the candidate it belongs to.
struct WindingSample
{
    glm::vec3 position;
    std::uint32_t candidate = 0;
};

/// Adds up winding numbers around many points, over elements (triangles, edges) that come one by one.
class WindingNumbers
{
public:
    WindingNumbers() = default;
    explicit WindingNumbers(std::span<const WindingSample> samples) { begin(samples); }

    /// Begins anew, with samples that live until the vote. Keeps its memory.
    void begin(std::span<const WindingSample> samples);

    /// Adds term(position) to each sample in `reach`, outside of which the term must be 0.
    template <class Term>
    void add(const Box& reach, Term&& term)
    {
        tree_.for_each_in(reach, [&](std::uint32_t i) { windings_[i] += term(positions_[i]); });
    }

    /// Sets lies_in for the candidates most of whose samples have a winding number other than 0.
    void vote(std::span<std::uint8_t> lies_in);

private:
    std::span<const WindingSample> samples_;
    std::vector<glm::vec3> positions_;
    PointTree tree_;
    std::vector<int> windings_, balance_;
};

}  // namespace kerf::core
