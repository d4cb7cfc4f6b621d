#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linear/closing.h"

namespace kerf::core::baseline {

using linear::Crossings;
using linear::Section;
using linear::SectionPath;
using linear::SideBuilder;

/// The mean of the section's points: where the report puts the centre of its fan.
glm::vec3 section_centre(const Section& section);

/// The area that a fan over the closed paths of a section covers too much.
struct FanFacts
{
    double excess = 0.0;  ///< twice the area of the triangles that are turned over; mesh units squared
    double rim = 0.0;     ///< length of the paths, mesh units
};

/// Measures the fan from `centre`. O(k).
FanFacts measure_fan(const Section& section, std::span<const SectionPath> paths, const glm::vec3& centre,
                     const Plane& plane);

/// Closes one side with the report's fan (section 3.2.3): a triangle from the section's centre to each edge of each
/// closed path, with vertices of their own whose normal is the plane's, flipped for the positive side, and planar uv.
/// Each path gets its own copy of the centre, so that paths that bound different pieces share nothing. If the centre
/// falls on a point of the path, that copy moves aside by `step`, the unit in the last place of the mesh's largest
/// coordinate: a fan from the rim could run along edges that the surface has already, or meet its apex's place again
/// where the rim touches itself. Right only if the section is star-shaped around the centre, a limit that the
/// comparison shows. Caps are grouped by solid. Returns the path of each triangle that is added. O(k).
std::vector<std::uint32_t> close_with_fan(SideBuilder& builder, Crossings& crossings, const Section& section,
                                          std::span<const SectionPath> paths, const glm::vec3& centre, double step,
                                          const Plane& plane, double uv_scale, std::uint32_t material);

/// Closes sections with the fan.
class FanClosing final : public linear::Closing
{
public:
    linear::ClosedSides close(BySide<SideBuilder>& builders, Crossings& crossings,
                              const linear::LinkedSection& linked) override;
};

}  // namespace kerf::core::baseline
