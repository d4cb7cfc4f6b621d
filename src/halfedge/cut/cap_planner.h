#pragma once

#include "halfedge/cut/caps.h"
#include "halfedge/cut/section.h"

namespace kerf::core::halfedge {

/// CAP: closes the loops of a section, set by set, with common/caps/section_closer.h.
class CapPlanner
{
public:
    /// Covers the closed loops. Outline edges that cancel are appended to Section::cancelled, and points where loops
    /// cross to Section::loop_points. Costs what SectionCloser::close() costs. May throw std::bad_alloc.
    void plan(const Plane& plane, CapQuality quality, const Found& found, Section& section, Caps& caps);

    /// Of the last plan(): see SectionCloser.
    double excess() const { return closer_.excess(); }
    std::uint64_t steps() const { return closer_.steps(); }

private:
    SectionCloser closer_;
    std::vector<CapLoop> loops_;
};

}  // namespace kerf::core::halfedge
