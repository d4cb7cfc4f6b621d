#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/caps/section_closer.h"
#include "common/cutting/plane_section.h"
#include "common/mesh/plane.h"

namespace kerf::core {

/// The triangles that close a section: what a cut would close it with. Keeps its memory.
class SectionFill
{
public:
    /// Closes the loops of a measured section: an outer loop together with the holes in it. `parents` are those of its
    /// paths (LoopNesting). Appends to PlaneSection::points where loops cross one another. `corners` gets three numbers
    /// of points for each triangle, counter-clockwise seen from the positive side. O(k) for convex loops, otherwise
    /// O(k log k). May throw std::bad_alloc.
    void close(const Plane& plane, CapQuality quality, std::span<const std::uint32_t> parents, PlaneSection& section,
               std::vector<std::uint32_t>& corners);

    /// By how much the triangles exceed the section's area: see SectionCloser::excess().
    double excess() const { return closer_.excess(); }

private:
    std::vector<CapLoop> loops_;
    SectionCaps caps_;
    SectionCloser closer_;
};

}  // namespace kerf::core
