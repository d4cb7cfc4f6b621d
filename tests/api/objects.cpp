#include "api/objects.h"

#include <kerf/shapes.h>

#include <stdexcept>

namespace kerf::test {

MeshInput Arrays::input() const
{
    MeshInput input;
    if (!positions.empty()) input.positions = positions.front().data();
    input.vertex_count = positions.size();
    if (!indices.empty()) input.indices = indices.data();
    input.triangle_count = indices.size() / 3;
    if (!normals.empty()) input.normals = normals.front().data();
    if (!uvs.empty()) input.uvs = uvs.front().data();
    if (!materials.empty()) input.triangle_materials = materials.data();
    return input;
}

Arrays cube_arrays(float lo, float hi)
{
    Arrays cube;
    for (int i = 0; i < 8; ++i)
        cube.positions.push_back({(i & 1) != 0 ? hi : lo, (i & 2) != 0 ? hi : lo, (i & 4) != 0 ? hi : lo});
    cube.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                    2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return cube;
}

Arrays two_cubes()
{
    Arrays both = cube_arrays(-1.0f, 1.0f);
    for (const std::array<float, 3>& p : cube_arrays(-1.0f, 1.0f).positions)
        both.positions.push_back({p[0] + 4.0f, p[1], p[2]});
    const std::size_t count = both.indices.size();
    for (std::size_t i = 0; i < count; ++i) both.indices.push_back(both.indices[i] + 8);
    return both;
}

Mesh mesh_of(const Arrays& arrays)
{
    Result<Mesh> mesh = Mesh::make(arrays.input());
    if (!mesh) throw std::runtime_error(mesh.reason());
    return *std::move(mesh);
}

Mesh shape(const std::string& name, std::uint64_t triangles)
{
    Result<Mesh> mesh = make_shape(name.c_str(), triangles);
    if (!mesh) throw std::runtime_error(mesh.reason());
    return *std::move(mesh);
}

std::vector<std::string> back_end_names()
{
    std::vector<std::string> names;
    for (std::size_t i = 0; i < back_end_count(); ++i)
        if (const std::string name = back_end(i).name; name != "halfedge/cgal") names.push_back(name);
    return names;
}

Object object_of(const Mesh& mesh, const std::string& back_end)
{
    PrepareOptions options;
    options.back_end_name = back_end.c_str();
    Result<Object> object = prepare(mesh, options);
    if (!object) throw std::runtime_error(object.reason());
    return *std::move(object);
}

Object cube(const std::string& back_end)
{
    return object_of(mesh_of(cube_arrays()), back_end);
}

Plane plane_at(double x, double y, double z, double nx, double ny, double nz)
{
    return Plane::at(Point(x, y, z), Normal(nx, ny, nz)).value();
}

namespace {

template <class T>
void append(std::string& bytes, std::span<const T> values)
{
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
}

}  // namespace

std::string bytes_of(const Mesh& mesh)
{
    const MeshArrays arrays = mesh.arrays();
    std::string bytes;
    append(bytes, arrays.positions);
    append(bytes, arrays.normals);
    append(bytes, arrays.uvs);
    append(bytes, arrays.indices);
    append(bytes, arrays.sources);
    append(bytes, arrays.kinds);
    append(bytes, arrays.triangle_materials);
    append(bytes, arrays.solids);
    for (std::size_t s = 0; s < mesh.stream_count(); ++s) append(bytes, mesh.stream(s).values);
    return bytes;
}

}  // namespace kerf::test
