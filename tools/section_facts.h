#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "common/cut.h"

namespace kerf::tools {

/// Area and length of a section's outline, from its loops.
struct SectionFacts
{
    double area = 0.0;    ///< signed sum of the closed loops' areas in the plane, mesh units squared
    double length = 0.0;  ///< of the closed loops
    std::size_t loops = 0, open_chains = 0;
};

/// O(k).
SectionFacts measure_section(std::span<const SectionLoop> loops, const glm::dvec3& normal);

/// Where the closed loops do not wind around once. Both are 0, up to rounding, for the section of a surface that does
/// not intersect itself, whether its loops touch or not.
struct WindingFacts
{
    double backward = 0.0;  ///< area with a negative winding number, times that number; mesh units squared
    double multiple = 0.0;  ///< area with a winding number above 1
};

/// Looks at edges that measure_winding() takes before it gives up: about a second.
inline constexpr std::uint64_t kMostWindingLooks = 20'000'000;

/// By slabs between the ends and crossings of edges (Bentley and Ottmann, "Algorithms for reporting and counting
/// geometric intersections", 1979, without their tree), each of which costs a look at every edge in it: nothing when
/// that takes more than kMostWindingLooks, as k edges do that cross themselves k^2 times. O(k) memory besides the
/// crossings.
std::optional<WindingFacts> measure_winding(std::span<const SectionLoop> loops, const glm::dvec3& normal);

}  // namespace kerf::tools
