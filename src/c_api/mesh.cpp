#include <kerf/c.h>
#include <kerf/io.h>

#include <vector>

#include "c_api/calls.h"
#include "c_api/handles.h"

namespace kerf::c_api {
namespace {

const char* text_or_nothing(const char* text)
{
    return text != nullptr ? text : "";
}

std::size_t stride_or(std::size_t given, std::size_t tight)
{
    return given != 0 ? given : tight;
}

/// What MeshInput only borrows.
struct Lists
{
    std::vector<Material> materials;
    std::vector<StreamInput> streams;
};

/// False if a struct of a list is of no good size.
bool read_lists(const kerf_mesh_input& from, Lists& to)
{
    for (std::size_t i = 0; i < from.material_count; ++i) {
        const std::optional<kerf_material> m = read_struct(&from.materials[i]);
        if (!m) return false;
        Material& made = to.materials.emplace_back();
        made.name = text_or_nothing(m->name);
        made.base_colour_image = text_or_nothing(m->image);
        const float* const c = m->base_colour;
        if (c[0] != 0.0f || c[1] != 0.0f || c[2] != 0.0f || c[3] != 0.0f) std::copy_n(c, 4, made.base_colour);
    }
    for (std::size_t i = 0; i < from.stream_count; ++i) {
        const std::optional<kerf_stream> s = read_struct(&from.streams[i]);
        if (!s) return false;
        to.streams.push_back({text_or_nothing(s->name), s->values, s->width, 0});
    }
    return true;
}

kerf_status make(const kerf_mesh_input& from, kerf_mesh*& mesh, const Reason& reason)
{
    if ((from.material_count > 0 && from.materials == nullptr) || (from.stream_count > 0 && from.streams == nullptr))
        return reason.wrong("materials or streams are counted, but there is no list of them");
    Lists lists;
    if (!read_lists(from, lists)) return reason.wrong(kWrongStruct);
    MeshInput input;
    input.positions = from.positions;
    input.position_stride = stride_or(from.position_stride, sizeof(Vec3f));
    input.vertex_count = from.vertex_count;
    input.indices = from.indices;
    input.triangle_count = from.triangle_count;
    input.normals = from.normals;
    input.normal_stride = stride_or(from.normal_stride, sizeof(Vec3f));
    if (from.crease_degrees != 0.0f) input.crease_degrees = from.crease_degrees;
    input.uvs = from.uvs;
    input.uv_stride = stride_or(from.uv_stride, sizeof(Vec2f));
    input.triangle_materials = from.triangle_materials;
    input.materials = lists.materials;
    input.streams = lists.streams;
    Result<Mesh> made = Mesh::make(input);
    if (!made) return reason.answer(made.status(), made.reason());
    mesh = new kerf_mesh(*std::move(made));
    return KERF_DONE;
}

}  // namespace
}  // namespace kerf::c_api

using namespace kerf::c_api;

kerf_status kerf_mesh_make(const kerf_mesh_input* input, kerf_mesh** mesh, char* reason, size_t reason_size)
{
    const Reason why(reason, reason_size);
    if (mesh == nullptr) return why.wrong("there is no place for the mesh");
    *mesh = nullptr;
    const std::optional<kerf_mesh_input> from = read_struct(input);
    if (!from) return why.wrong(kWrongStruct);
    return with_memory(why, [&] { return make(*from, *mesh, why); });
}

kerf_status kerf_mesh_read(const char* path, kerf_mesh** mesh, char* reason, size_t reason_size)
{
    const Reason why(reason, reason_size);
    if (mesh == nullptr) return why.wrong("there is no place for the mesh");
    *mesh = nullptr;
    kerf::Result<kerf::Mesh> read = kerf::read_mesh(path);
    if (!read) return why.answer(read.status(), read.reason());
    return with_memory(why, [&] {
        *mesh = new kerf_mesh(*std::move(read));
        return KERF_DONE;
    });
}

kerf_status kerf_mesh_write(const kerf_mesh* mesh, const char* path, char* reason, size_t reason_size)
{
    const Reason why(reason, reason_size);
    if (mesh == nullptr) return why.wrong("there is no mesh");
    const kerf::Outcome written = kerf::write_mesh(mesh->mesh, path);
    return why.answer(written.status(), written.reason());
}

kerf_status kerf_mesh_get_arrays(const kerf_mesh* mesh, kerf_mesh_arrays* arrays)
{
    if (mesh == nullptr) return KERF_INVALID_ARGUMENT;
    const kerf::MeshArrays from = mesh->mesh.arrays();
    if (from.indices.empty()) return KERF_OUT_OF_MEMORY;
    kerf_mesh_arrays to{};
    to.point_count = from.point_count;
    to.vertex_count = from.positions.size();
    to.triangle_count = from.indices.size() / 3;
    to.positions = &from.positions.data()->x;
    to.normals = &from.normals.data()->x;
    to.uvs = &from.uvs.data()->x;
    to.points = from.points.data();
    to.indices = from.indices.data();
    to.sources = from.sources.data();
    to.triangle_materials = from.triangle_materials.data();
    to.solids = from.solids.data();
    static_assert(sizeof(kerf::TriangleKind) == 1 && int(kerf::TriangleKind::cap) == 1);
    to.is_cap = reinterpret_cast<const uint8_t*>(from.kinds.data());
    to.stream_count = mesh->mesh.stream_count();
    return fill_struct(arrays, to);
}

kerf_status kerf_mesh_get_stream(const kerf_mesh* mesh, size_t i, kerf_stream* stream)
{
    if (mesh == nullptr || i >= mesh->mesh.stream_count()) return KERF_INVALID_ARGUMENT;
    const kerf::Stream from = mesh->mesh.stream(i);
    kerf_stream to{};
    to.name = from.name;
    to.width = from.width;
    to.values = from.values.data();
    return fill_struct(stream, to);
}
