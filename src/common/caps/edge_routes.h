#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "common/mesh/index.h"

namespace kerf {

/// What edges run over, each from its start to its end.
struct EdgeRoutes
{
    std::vector<Index> points;        ///< numbers of places, those of `added` behind the others
    std::vector<std::size_t> starts;  ///< first of each edge, and the number of points at the end
    std::vector<glm::dvec2> added;    ///< where two edges cross
    std::uint64_t steps = 0;          ///< predicates, counted up
};

/// Finds where edges meet that may cross all over.
class RouteFinder
{
public:
    virtual ~RouteFinder() = default;

    /// Leads each edge over every place that lies in it, and over one more wherever it crosses another: rounded to
    /// double, which may lead it over others beside that, and back. What comes out meets in places alone. False where
    /// more than `most_added` are new or the routes have more than `most_points`, where two places are equal and where
    /// an edge ends at its start. May throw std::bad_alloc, nothing else. O((n + crossings) log n + points) expected.
    virtual bool find(std::span<const glm::dvec2> places, std::span<const std::array<Index, 2>> edges,
                      std::size_t most_added, std::size_t most_points, EdgeRoutes& routes) = 0;
};

}  // namespace kerf
