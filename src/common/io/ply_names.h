#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "common/io/ply_header.h"
#include "common/mesh/indexed_mesh.h"

// The meaning of a PLY vertex's numbers. Reader and writer share the names, so that streams read back as written:
//   x y z, nx ny nz, s t (reading: also u v, texture_u texture_v, texture_s texture_t)
//   red green blue [alpha]   stream "color"; integers are divided by their largest value
//   NAME_0 NAME_1 ...        stream NAME of that width
//   NAME                     stream NAME of width 1

namespace kerf::core::io {

/// A stream that a PLY vertex carries.
struct PlyStream
{
    std::string name;
    std::uint32_t width = 1;
};

/// The destination of a property's value.
struct PlyDestination
{
    static constexpr std::size_t kCore = std::numeric_limits<std::size_t>::max();

    std::size_t stream = kCore;   ///< index of the stream, or kCore for position, normal and uv
    std::uint32_t component = 0;  ///< of the stream's values, or of the eight floats of a Vertex
    float one = 1.0f;             ///< divide by this
};

struct PlyVertexLayout
{
    std::vector<PlyDestination> destinations;  ///< one for each property, meaningless for lists
    std::vector<PlyStream> streams;
    bool has_position = false;
};

PlyVertexLayout ply_vertex_layout(const PlyElement& vertex);

/// The names under which the components of a stream are written, so that ply_vertex_layout() finds the stream again.
/// Characters that would end a name become '_'.
std::vector<std::string> ply_property_names(const VertexStream& stream);

}  // namespace kerf::core::io
