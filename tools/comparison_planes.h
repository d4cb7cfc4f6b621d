#pragma once

#include <cstdint>
#include <string>

#include "tools/flat_mesh.h"
#include "tools/surface_keys.h"

namespace kerf::tools {

/// Which planes to choose.
enum class PlaneMix : std::uint8_t
{
    nasty,   ///< random ones among planes through vertices, along edges, in faces, along axes
    random,  ///< only random ones through the middle
};

struct ChosenPlane
{
    std::string kind;  ///< "random", "in a face", ...
    Plane plane = Plane::z(0.0).value();
};

/// Plane `number` of a sequence for this surface. It depends on the surface triangles, the number and the seed only, so
/// that back ends that agree see the same planes. The mix begins with the three axis planes and a diagonal plane
/// through the middle. The surface must have a triangle. O(n) for planes through the middle, otherwise O(1).
ChosenPlane choose_plane(const SurfaceKeys& surface, PlaneMix mix, std::uint64_t number, std::uint64_t seed);

}  // namespace kerf::tools
