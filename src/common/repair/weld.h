#pragma once

#include <cstdint>
#include <span>

#include "common/mesh/buffer.h"
#include "common/mesh/indexed_mesh.h"

namespace kerf::core {

/// Which vertices are at one place.
struct Weld
{
    Buffer<std::uint32_t> points;   ///< for each vertex the number of its position, dense, in order of first occurrence
    std::uint32_t point_count = 0;  ///< number of different positions
    bool is_finite = true;          ///< whether all coordinates are
};

/// Numbers the different positions; positions are equal if their bits are, with -0 taken as +0. O(n), by hashing.
Weld weld_positions(std::span<const Vertex> vertices);

/// For each vertex the first one with the same point, uv and stream values, and, unless `ignore_normals`, the same
/// normal, all bit for bit. O(n), by hashing.
Buffer<std::uint32_t> first_equal_vertices(const Weld& weld, std::span<const Vertex> vertices,
                                           std::span<const VertexStream> streams, bool ignore_normals);

}  // namespace kerf::core
