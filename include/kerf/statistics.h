#pragma once

#include <kerf/export.h>

#include <cstddef>
#include <cstdint>

namespace kerf {

/// @addtogroup statistics
/// The cost of a cut: exact counters, and times. For benchmarks and panels; games can do without.
/// @{

/// Where the time of a cut goes. A back end leaves the phases that it does not have at 0.
enum class Phase : unsigned char
{
    find = 0,   ///< which triangles are on which side, which cross
    walk = 1,   ///< half-edge: following the section from triangle to triangle
    split = 2,  ///< dividing the crossing triangles; half-edge: also writing them and the caps into the half-edge mesh
    copy = 3,   ///< linear: untouched triangles and their vertices into the pieces
    cap = 4,    ///< linking the section into loops and closing it
    rebuild = 5,     ///< half-edge: trees and index ranges of the pieces
    components = 6,  ///< connected pieces
    growth = 7,      ///< reallocation, if the room reserved by prepare() is used up
};
/// How many phases there are.
inline constexpr std::size_t kPhaseCount = 8;

/// "find", "walk", ...; "unknown" for a number that is none of them. Never null.
KERF_API const char* text(Phase phase) noexcept;

/// What a cut did. Counters are exact and the same on every run; times are not.
///
///     const kerf::CutStatistics& cost = cut.statistics();
///     std::printf("%g ms for %g of %g triangles\n", cost.milliseconds(), double(cost.crossing_triangles),
///                 double(cost.triangles));
struct CutStatistics
{
    std::uint64_t triangles = 0;           ///< of the object before the cut
    std::uint64_t crossing_triangles = 0;  ///< with vertices strictly on both sides of the plane
    std::uint64_t crossing_surface = 0;    ///< those of them that are no caps: the same number for every back end
    std::uint64_t section_loops = 0;       ///< closed loops of the section
    std::uint64_t open_chains = 0;         ///< polylines of the section that end at the boundary of an open mesh
    std::uint64_t nodes_visited = 0;       ///< tree nodes looked at
    std::uint64_t triangles_touched = 0;   ///< distinct triangle records read or written
    std::uint64_t cap_steps = 0;           ///< half-edge: steps to close the section; 0 for convex ones
    std::uint64_t bytes_to_upload = 0;     ///< vertex and index bytes that the GPU does not have yet, both sides
    std::uint64_t bytes_grown = 0;         ///< reallocated because reserved room was used up
    double phase_ms[kPhaseCount] = {};     ///< wall-clock milliseconds by Phase

    /// The sum of all phases.
    double milliseconds() const noexcept
    {
        double sum = 0.0;
        for (const double ms : phase_ms) sum += ms;
        return sum;
    }
};

/// @}

}  // namespace kerf
