#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "common/mesh/index.h"

namespace kerf::core {

/// The places that edges run over, each edge from its start to its end.
struct EdgeRoutes
{
    std::vector<Index> points;        ///< numbers of places, those of `added` behind the others
    std::vector<std::size_t> starts;  ///< first of each edge, and the number of points at the end
    std::vector<glm::dvec2> added;    ///< where two edges cross
    std::uint64_t steps = 0;          ///< predicates, counted up
};

/// Finds where edges meet, however many cross.
class RouteFinder
{
public:
    virtual ~RouteFinder() = default;

    /// Leads each edge over every place in it, and over a new one wherever it crosses another edge. Rounding new places
    /// to double may lead an edge over others beside it, and back. Routes meet in places only. False if over
    /// `most_added` places are new, routes have over `most_points`, two places are equal, or an edge ends at its start.
    /// May throw std::bad_alloc, nothing else. O((n + crossings) log n + points) expected.
    virtual bool find(std::span<const glm::dvec2> places, std::span<const std::array<Index, 2>> edges,
                      std::size_t most_added, std::size_t most_points, EdgeRoutes& routes) = 0;
};

}  // namespace kerf::core
