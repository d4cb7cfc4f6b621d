#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "tools/flat_mesh.h"

namespace kerf::tools {

/// Area and length of a section's outline, from its loops.
struct SectionFacts
{
    double area = 0.0;    ///< signed sum of the closed loops' areas in the plane, mesh units squared
    double length = 0.0;  ///< of the closed loops
    std::size_t loops = 0, open_chains = 0;
};

/// O(k).
SectionFacts measure_section(std::span<const Outline> loops, const glm::dvec3& normal);

/// Where closed loops do not wind around once. Both are 0, up to rounding, for the section of a surface that does
/// not intersect itself, whether its loops touch or not.
struct WindingFacts
{
    double backward = 0.0;  ///< area with a negative winding number, times that number; mesh units squared
    double multiple = 0.0;  ///< area with a winding number above 1
};

/// An edge of a section, in its direction.
struct SectionStep
{
    glm::vec3 from, to;
};

/// The closed loops step by step.
std::vector<SectionStep> steps_of(std::span<const Outline> loops);

/// The section of each solid, in no order: what bounds its part of the negative fragment, but for the caps with
/// this material. O(n log n).
std::vector<std::vector<SectionStep>> sections_of_solids(const FlatMesh& negative, std::uint32_t cap_material);

/// Of the sections of solids the closed loops: other edges, too, bound a solid's part of an open mesh. A loop is of the
/// first solid that has it. Nothing if one is of none. O(n log n), times the solids that have edges in common.
std::optional<std::vector<std::vector<SectionStep>>> keep_loops(std::span<const std::vector<SectionStep>> sections,
                                                                std::span<const Outline> loops);

/// Looks at edges that measure_winding() takes before it gives up: about a second.
inline constexpr std::uint64_t kMostWindingLooks = 20'000'000;

/// By slabs between the ends and crossings of edges (Bentley and Ottmann, "Algorithms for reporting and counting
/// geometric intersections", 1979, without their tree), each of which costs a look at every edge in it: nothing when
/// that takes more than kMostWindingLooks, as k edges do that cross themselves k^2 times. O(k) memory besides the
/// crossings.
std::optional<WindingFacts> measure_winding(std::span<const SectionStep> section, const glm::dvec3& normal);

}  // namespace kerf::tools
