#pragma once

#include "viewer/sim/body_proxies.h"
#include "viewer/sim/cut_log.h"
#include "viewer/sim/cutting_plane.h"
#include "viewer/sim/world.h"

namespace kerf::sim {

/// How pieces are made.
struct CutBodyOptions
{
    ProxyKind proxy = ProxyKind::bounded_hull;
    bool hash_surfaces = false;   ///< and measure caps
    ObjectId* last_id = nullptr;  ///< the last id given out; counts up
};

/// Cuts a body of the world by a plane of the world: the object in its own frame, tumbling included; a body for each
/// connected piece, which takes over its share of momentum (parting.h). Where the world has no room for all of them the
/// smallest are dropped, with their share; at least the two largest stay. In a crowd of kMostNeighbours only the
/// largest stays. Pieces get their ids in a fixed order: positive side first, then by their boxes, which both back ends
/// agree on. Where nothing was cut the body is left as it was, marked as missed by this swipe.
///
/// Fills in everything of `record` but its number, tick and swipe, which it reads. Costs what the cut costs, and O(1) a
/// piece for proxies that do; hashing surfaces and measuring caps is O(n) and not
/// part of the times.
void cut_body(World& world, ObjectId id, const WorldPlane& plane, const CutBodyOptions& options, CutRecord& record);

}  // namespace kerf::sim
