#pragma once

#include <cstdint>

#include "halfedge/cut/cap_planner.h"
#include "halfedge/cut/find.h"
#include "halfedge/cut/find_parts.h"
#include "halfedge/cut/planned_pieces.h"
#include "halfedge/cut/rebuild.h"
#include "halfedge/cut/section.h"
#include "halfedge/cut/stitch_plan.h"
#include "halfedge/cut/walk.h"

namespace kerf::core::halfedge {

/// The steps of a cut and their results. All of it keeps its memory from cut to cut.
struct CutWorkspace
{
    Found found;
    Section section;
    Pieces pieces;
    Caps caps;
    StitchPlan stitch_plan;

    Finder finder;
    Walker walker;
    PartFinder part_finder;
    CapPlanner cap_planner;
    Rebuilder rebuilder;

    /// Makes room for a cut that crosses so many triangles, and touches it.
    void reserve(std::size_t crossings);
    /// Forgets the last cut of the universe.
    void begin(Universe& universe);
    /// Stamps, from the universe's `stamp_base` on, that the last cut has put on faces.
    std::uint64_t stamps_used() const { return found.crossings.size() + part_finder.stamps_used(); }
};

}  // namespace kerf::core::halfedge
