#pragma once

#include <cstdint>
#include <vector>

#include "halfedge/cut/cap_planner.h"
#include "halfedge/cut/crossing_numbers.h"
#include "halfedge/cut/find.h"
#include "halfedge/cut/find_parts.h"
#include "halfedge/cut/irregular/irregular.h"
#include "halfedge/cut/planned_pieces.h"
#include "halfedge/cut/quick_outline.h"
#include "halfedge/cut/rebuild.h"
#include "halfedge/cut/section.h"
#include "halfedge/cut/stitch_plan.h"
#include "halfedge/cut/walk.h"

namespace kerf::core::halfedge {

/// The steps of a cut and their results. All of it keeps its memory from cut to cut, and nothing else.
struct CutWorkspace
{
    Found found;
    Section section;
    Pieces pieces;
    Caps caps;
    StitchPlan stitch_plan;

    // Of sections that change nothing.
    QuickOutline quick_outline;
    FaceTable section_numbers;

    std::vector<NodeId> waiting_nodes;  ///< while it is looked whether the plane misses
    Finder finder;
    Walker walker;
    OutlineLinker outline_linker;
    PartFinder part_finder;
    CapPlanner cap_planner;
    Rebuilder rebuilder;

    /// Makes room for a cut that crosses so many triangles, and touches it.
    void reserve(std::size_t crossings);
    /// Before a cut in a universe.
    void begin(Universe& universe);
    /// After it, also if it failed: forgets all of it. What end() has not seen yet belongs to this universe.
    void end(Universe& universe);
    /// Forgets all results.
    void clear();
};

}  // namespace kerf::core::halfedge
