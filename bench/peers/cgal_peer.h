#pragma once

#include <functional>
#include <string>
#include <vector>

#include "bench/peers/peer_inputs.h"

namespace kerf::bench {

/// What a library made of the cuts of one mesh.
struct PeerRow
{
    std::string peer, mesh;
    std::size_t triangles = 0, planes = 0, right = 0;
    double ms = 0.0;                       ///< per cut, both sides; processor time; mean of the planes
    double least_ms = 0.0, most_ms = 0.0;  ///< of the planes, each of which is cut once
    std::string verdict;                   ///< "right", or what is the matter and how often
};

/// CGAL's Polygon_mesh_processing::clip with clip_volume, once for each side.
PeerRow time_cgal_clip(const PeerInput& input, double budget_seconds);

/// CGAL's Polygon_mesh_processing::split: one surface that is cut along the plane, without caps.
PeerRow time_cgal_split(const PeerInput& input, double budget_seconds);

}  // namespace kerf::bench
