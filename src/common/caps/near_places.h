#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "common/mesh/index.h"

// Places in the plane of a section that are closer to one another than the distance that rounding moves them.

namespace kerf::core {

/// Gives each place a stand-in, at most `radius` away along each axis. A stand-in stands for itself, and stand-ins are
/// farther than that from one another. `order` says which place comes first. O(n) expected.
std::vector<Index> stand_ins(std::span<const glm::dvec2> places, std::span<const Index> order, double radius);

/// A tree over places, to find those beside an edge: halved along x and y in turn.
class PlaceTree
{
public:
    /// Builds the tree over the places numbered in `which`. O(n log n).
    void build(std::span<const glm::dvec2> places, std::vector<Index> which);

    /// Appends the places within `radius` of the edge from a to b, in the order in which the edge passes them. O(log n)
    /// for few and short edges, at most O(sqrt(n)) for a search in vain. Counts the places that it looks at.
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

}  // namespace kerf::core
