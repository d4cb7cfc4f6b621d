#include <limits>
#include <string>

#include "common/io/bytes.h"
#include "common/io/ply_names.h"
#include "common/io/write_formats.h"

namespace kerf::core::io {

namespace {

constexpr std::size_t kFlushBytes = 1 << 20;

std::string header(const IndexedMesh& mesh)
{
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment Written by Kerf\n";
    text += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
        text += "property float " + std::string(name) + "\n";
    for (const VertexStream& stream : mesh.streams)
        for (const std::string& name : ply_property_names(stream)) text += "property float " + name + "\n";
    text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
    // Many programs know signed indices only.
    const bool fits = mesh.vertices.size() <= std::size_t{std::numeric_limits<std::int32_t>::max()};
    text += std::string("property list uchar ") + (fits ? "int" : "uint") + " vertex_indices\nend_header\n";
    return text;
}

}  // namespace

void write_ply(ByteSink& file, const IndexedMesh& mesh)
{
    std::string bytes = header(mesh);
    const auto flush = [&](std::size_t above) {
        if (bytes.size() <= above) return;
        file.write(bytes);
        bytes.clear();
    };
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const Vertex& v = mesh.vertices[i];
        for (const float value :
             {v.position.x, v.position.y, v.position.z, v.normal.x, v.normal.y, v.normal.z, v.uv.x, v.uv.y})
            store_little(bytes, value);
        for (const VertexStream& stream : mesh.streams)
            for (std::uint32_t k = 0; k < stream.width; ++k) store_little(bytes, stream.values[i * stream.width + k]);
        flush(kFlushBytes);
    }
    for (const Triangle& triangle : mesh.triangles) {
        store_little(bytes, std::uint8_t{3});
        for (const std::uint32_t corner : triangle) store_little(bytes, corner);
        flush(kFlushBytes);
    }
    flush(0);
}

}  // namespace kerf::core::io
