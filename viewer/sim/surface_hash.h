#pragma once

#include <kerf/object.h>

#include <cstdint>

namespace kerf::sim {

/// Hash of the object's `surface` triangles as a multiset: positions, normals, uv and material of each, whatever their
/// order and whichever corner comes first. Both back ends give the same; caps, which they triangulate differently, are
/// left out. O(n).
/// @throws std::bad_alloc
std::uint64_t surface_hash(const Object& object);

}  // namespace kerf::sim
