#include "support/public_mesh.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

namespace kerf::test {

Mesh mesh_of(const core::TriangleSoup& soup, MeshReport* report)
{
    MeshInput input;
    if (!soup.vertices.empty()) {
        const core::Vertex& first = soup.vertices.front();
        input.positions = &first.position.x;
        if (soup.has_normals) input.normals = &first.normal.x;
        input.uvs = &first.uv.x;
    }
    input.position_stride = input.normal_stride = input.uv_stride = sizeof(core::Vertex);
    input.vertex_count = soup.vertices.size();
    if (!soup.triangles.empty()) input.indices = soup.triangles.front().data();
    input.triangle_count = soup.triangles.size();
    if (!soup.triangle_materials.empty()) input.triangle_materials = soup.triangle_materials.data();
    std::vector<kerf::Material> materials;
    for (const core::Material& from : soup.materials) {
        kerf::Material& to = materials.emplace_back();
        to.name = from.name.c_str();
        for (int c = 0; c < 4; ++c) to.base_colour[c] = from.colour[c];
        to.base_colour_image = from.texture.c_str();
    }
    input.materials = materials;
    std::vector<StreamInput> streams;
    for (const core::VertexStream& stream : soup.streams)
        streams.push_back({stream.name.c_str(), stream.values.data(), stream.width, 0});
    input.streams = streams;
    Result<Mesh> mesh = Mesh::make(input, report);
    if (!mesh) throw std::runtime_error(mesh.reason());
    return *std::move(mesh);
}

}  // namespace kerf::test
