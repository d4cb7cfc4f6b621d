#pragma once

#include <kerf/mesh.h>
#include <kerf/plane.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

// What other libraries are given: the meshes and planes of kerf_bench, as bare triangles that share their corners.

namespace kerf::bench {

/// A closed mesh without attributes, the planes that cut it, and what must come out.
struct PeerInput
{
    std::string name;
    std::vector<Vec3f> points;
    std::vector<std::array<std::uint32_t, 3>> triangles;  ///< index into `points`
    std::vector<Plane> planes;
    std::vector<double> volumes;  ///< of the negative side of each plane, by the baseline
    double volume = 0.0;          ///< of the whole
};

/// Sides must have the right volume to this share of the whole: what rounding cut points to float may change.
inline constexpr double kVolumeShare = 1e-6;

/// The asteroid of about so many triangles.
PeerInput asteroid_input(std::uint64_t triangles);

/// The report's fifteen models.
std::vector<PeerInput> model_inputs();

}  // namespace kerf::bench
