#pragma once

#include "bench/peers/peer_inputs.h"
#include "bench/peers/peer_row.h"

namespace kerf::bench {

/// CGAL's Polygon_mesh_processing::clip with clip_volume, once for each side.
PeerRow time_cgal_clip(const PeerInput& input, double budget_seconds);

/// CGAL's Polygon_mesh_processing::split: one surface that is cut along the plane, without caps.
PeerRow time_cgal_split(const PeerInput& input, double budget_seconds);

}  // namespace kerf::bench
