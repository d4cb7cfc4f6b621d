#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

// The cost of a cut: exact counters, and times.

namespace kerf::core {

/// Where the time of a cut goes. A back end leaves the phases that it does not have at 0.
enum class Phase : std::uint8_t
{
    find,        ///< which triangles are on which side, which cross
    walk,        ///< half-edge: following the section from triangle to triangle
    split,       ///< dividing the crossing triangles; half-edge: also writing them and the caps into the half-edge mesh
    copy,        ///< baseline: untouched triangles and their vertices into the fragments
    cap,         ///< linking the section into loops and closing it
    rebuild,     ///< half-edge: trees and index ranges of the fragments
    components,  ///< connected pieces
    growth,      ///< reallocation, when the room reserved by prepare is used up
};
inline constexpr std::size_t kPhaseCount = 8;
std::string_view name_of(Phase phase);

/// Wall-clock milliseconds for each phase.
struct PhaseTimes
{
    std::array<double, kPhaseCount> ms{};

    /// @throws std::out_of_range  there is no such phase
    double& operator[](Phase phase) { return ms.at(static_cast<std::size_t>(phase)); }
    double operator[](Phase phase) const { return ms.at(static_cast<std::size_t>(phase)); }
    double total() const;
};

/// What a cut did. Counters are exact and the same on every run; times are not.
struct CutStatistics
{
    std::uint64_t triangles = 0;           ///< of the object before the cut
    std::uint64_t crossing_triangles = 0;  ///< with vertices strictly on both sides of the plane
    std::uint64_t crossing_surface = 0;    ///< those of them that are no caps: the same number for every back end
    std::uint64_t section_loops = 0;  ///< closed loops of the section; where several edges of it leave one point, every
                                      ///< back end divides it by the same rule
    std::uint64_t open_chains = 0;    ///< section polylines that end at the boundary of an open mesh
    std::uint64_t nodes_visited = 0;  ///< tree nodes looked at
    std::uint64_t triangles_touched = 0;  ///< distinct triangle records read or written
    std::uint64_t cap_steps = 0;  ///< half-edge: corners and edges looked at, and predicates of CGAL's, to close the
                                  ///< section; 0 for convex ones
    std::uint64_t bytes_to_upload = 0;  ///< vertex and index bytes that the GPU does not have yet, both sides
    std::uint64_t bytes_grown = 0;      ///< reallocated because reserved room was used up
    PhaseTimes phases;
};

}  // namespace kerf::core
