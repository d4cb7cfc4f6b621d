#pragma once

#include <kerf/mesh.h>
#include <kerf/plane.h>

#include <cstdint>
#include <string>
#include <vector>

namespace kerf::bench {

/// The planes that `shape` is cut by in turn: seeded random directions through its middle. As many at every size, and
/// in the same directions: times of different sizes and back ends are means over the same cuts.
std::vector<Plane> planes_of_shape(const Mesh& shape);

/// `asteroid` (triangles in a coherent order) or `shuffled` (the same in a random order) with about `triangles`
/// triangles. The last one made is kept: benchmarks of one size follow one another, and the large ones should not all
/// stay in memory.
const Mesh& timed_shape(const std::string& name, std::uint64_t triangles);

}  // namespace kerf::bench
