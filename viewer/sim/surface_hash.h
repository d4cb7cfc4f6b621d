#pragma once

#include <cstdint>

#include "common/cutting/cut.h"

namespace kerf::sim {

/// Hash of the object's `surface` triangles as a multiset: positions, normals, uv and material of each, whatever their
/// order and whichever corner comes first. Both back ends give the same; caps, which they triangulate differently, are
/// left out. O(n).
std::uint64_t surface_hash(const Cuttable& object);

}  // namespace kerf::sim
