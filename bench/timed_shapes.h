#pragma once

#include <cstdint>
#include <string>

#include "common/indexed_mesh.h"

namespace kerf::bench {

/// `asteroid` (triangles in a coherent order) or `shuffled` (the same in a random order) with about `triangles`
/// triangles. The last one made is kept: benchmarks of one size follow one another, and the large ones should not all
/// stay in memory.
const IndexedMesh& timed_shape(const std::string& name, std::uint64_t triangles);

}  // namespace kerf::bench
