#include "tools/flat_mesh.h"

#include <algorithm>
#include <stdexcept>

namespace kerf::tools {

FlatMesh flat(const Mesh& mesh)
{
    const MeshArrays arrays = mesh.arrays();
    FlatMesh result;
    result.vertices.reserve(arrays.positions.size());
    for (std::size_t v = 0; v < arrays.positions.size(); ++v)
        result.vertices.push_back(
            {to_glm(arrays.positions[v]), to_glm(arrays.normals[v]), {arrays.uvs[v].x, arrays.uvs[v].y}});
    result.points.assign(arrays.points.begin(), arrays.points.end());
    result.point_count = arrays.point_count;
    result.sources.assign(arrays.sources.begin(), arrays.sources.end());
    result.triangles.reserve(arrays.sources.size());
    for (std::uint32_t t = 0; t < arrays.sources.size(); ++t) {
        const std::size_t first = std::size_t{3} * t;
        result.triangles.push_back({arrays.indices[first], arrays.indices[first + 1], arrays.indices[first + 2]});
        const TriangleGroup like{t, 1, arrays.triangle_materials[t], arrays.solids[t], arrays.kinds[t]};
        TriangleGroup* const last = result.groups.empty() ? nullptr : &result.groups.back();
        if (last != nullptr && last->material == like.material && last->solid == like.solid && last->kind == like.kind)
            ++last->count;
        else
            result.groups.push_back(like);
    }
    for (std::size_t s = 0; s < mesh.stream_count(); ++s) {
        const Stream stream = mesh.stream(s);
        result.streams.push_back({stream.name, stream.width, {stream.values.begin(), stream.values.end()}});
    }
    for (std::size_t m = 0; m < mesh.material_count(); ++m) {
        const Material material = mesh.material(m);
        MaterialLook& look = result.materials.emplace_back(MaterialLook{material.name, {}, material.base_colour_image});
        std::copy_n(material.base_colour, look.colour.size(), look.colour.begin());
    }
    return result;
}

FlatMesh flat(const Object& object)
{
    const Result<Mesh> mesh = object.mesh();
    if (!mesh) throw std::runtime_error(mesh.reason());
    return flat(*mesh);
}

std::vector<Outline> outlines_of(const Object& object)
{
    std::vector<Outline> outlines;
    for (std::size_t i = 0; i < object.loop_count(); ++i) {
        const SectionLoop loop = object.loop(i);
        Outline& outline = outlines.emplace_back();
        outline.closed = loop.is_closed;
        for (const Vec3f& p : loop.points) outline.points.push_back(to_glm(p));
    }
    return outlines;
}

}  // namespace kerf::tools
