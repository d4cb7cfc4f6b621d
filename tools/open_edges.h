#pragma once

#include <cstdint>

#include "tools/flat_mesh.h"

namespace kerf::tools {

/// How many directed edges, by point id, lack a reverse: 0 for a closed mesh. O(n).
std::uint64_t open_edges(const FlatMesh& mesh);

}  // namespace kerf::tools
