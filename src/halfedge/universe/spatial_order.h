#pragma once

#include <span>

#include "common/mesh/index.h"
#include "common/repair/proven_mesh.h"
#include "halfedge/universe/scratch_array.h"

namespace kerf::core::halfedge {

/// The triangles of a mesh in an order in which those near each other in space lie near each other in memory: by
/// (group, shell, place of the centre along a Morton curve, number). `group_of` gives each triangle its group, below
/// `groups`; it may be empty if there is one. O(n), by radix sort. The order does not depend on how many
/// threads make it.
ScratchArray<Index> spatial_order(const ProvenMesh& proven, std::span<const Index> group_of, std::size_t groups,
                                  bool on_two_threads);

}  // namespace kerf::core::halfedge
