#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "common/mesh/index.h"

// Places in the plane of a section that are nearer to one another than rounding moves them.

namespace kerf {

/// For each place one that stands for it, `radius` away at most along each axis; those that stand for others stand for
/// themselves, and are farther from one another. `order` says which place comes first. O(n) expected.
std::vector<Index> stand_ins(std::span<const glm::dvec2> places, std::span<const Index> order, double radius);

/// Some places, to be found beside edges: halved along x and y in turn.
class PlaceTree
{
public:
    /// `which` of the places. O(n log n).
    void build(std::span<const glm::dvec2> places, std::vector<Index> which);

    /// Appends those that lie within `radius` of the edge from a to b, in the order in which it passes them. O(log n)
    /// for few and short edges, O(sqrt(n)) at most for what is found in vain. Counts the places that it looks at.
    void append_beside(const glm::dvec2& a, const glm::dvec2& b, double radius, std::vector<Index>& found,
                       std::uint64_t& looks) const;

private:
    struct Edge
    {
        glm::dvec2 from, direction;  ///< of length 1
        double length, radius;
    };
    void halve(std::size_t first, std::size_t last, int axis);
    void search(const Edge& edge, std::size_t first, std::size_t last, int axis, std::vector<Index>& found,
                std::uint64_t& looks, glm::dvec2 lo, glm::dvec2 hi) const;

    std::span<const glm::dvec2> places_;
    std::vector<Index> which_;
};

}  // namespace kerf
