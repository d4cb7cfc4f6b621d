#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "linear/section.h"
#include "linear/side_builder.h"

// How the sides of a cut are closed: with right caps (right_caps.h), or with the report's fan (baseline/fan.h).

namespace kerf::core::linear {

/// A section, linked into paths.
struct LinkedSection
{
    const Section& section;
    std::span<const SectionPath> paths;
    std::span<const std::uint64_t> tags;  ///< of each edge; all edges of a path have one: what the path bounds
    const Plane& plane;
    double area;             ///< signed, of the closed paths; mesh units squared
    double unit;             ///< in the last place of the mesh's largest coordinate, mesh units
    std::uint32_t material;  ///< of the caps
    double uv_scale;         ///< CutOptions::cap_uv_scale
    CapQuality quality;      ///< CutOptions::cap_quality
    bool with_caps;          ///< otherwise nothing is added
};

/// What closing has added.
struct ClosedSides
{
    /// Of each triangle, in the order in which they were added: a path that bounds what it closes.
    BySide<std::vector<std::uint32_t>> path_of_cap;
    bool caps_exceed_section = false;  ///< see CutResult
    std::uint64_t steps = 0;           ///< see CutStatistics::cap_steps
};

/// A way to close both sides of a section.
class Closing
{
public:
    virtual ~Closing() = default;

    /// Appends caps to both sides, with vertices of their own, in groups by solid. Called once for each cut, also if it
    /// is to have no caps.
    virtual ClosedSides close(BySide<SideBuilder>& builders, Crossings& crossings, const LinkedSection& linked) = 0;

    /// Puts right what caps have left undone at a finished fragment, if there is anything.
    virtual void finish(Fragment& fragment, const Plane& plane)
    {
        static_cast<void>(fragment), static_cast<void>(plane);
    }
};

}  // namespace kerf::core::linear
