#include <kerf/shapes.h>

#include <memory>
#include <utility>

#include "api/convert.h"
#include "api/mesh_data.h"
#include "api/no_memory.h"
#include "common/shapes/hard_sections.h"
#include "common/shapes/shapes.h"

namespace kerf {

namespace {

/// The share of the time that it takes to make the triangles; the rest joins them to a mesh.
constexpr double kShaping = 0.4;

Result<Mesh> cancelled_shape()
{
    return {Status::cancelled, Sentence("the caller asked to stop; there is no shape")};
}

}  // namespace

Result<Mesh> make_shape(const char* name, std::uint64_t triangles, const ShapeOptions& options) noexcept
{
    return result_of<Mesh>("there is not enough memory for the shape", [&]() -> Result<Mesh> {
        const auto goes_on = [&](double share) {
            return options.progress == nullptr || options.progress(options.user, share);
        };
        if (!goes_on(0.0)) return cancelled_shape();
        std::optional<core::TriangleSoup> soup =
            core::shapes::make(name != nullptr ? name : "", triangles, options.seed);
        if (!soup) return {Status::invalid_argument, Sentence("there is no such shape; shape_name() lists them")};
        if (options.material != nullptr) {
            soup->materials = {to_core(*options.material)};
            soup->triangle_materials.clear();
        }
        if (!goes_on(kShaping)) return cancelled_shape();
        core::Repaired repaired = core::repair(*std::move(soup), core::FactsWanted::none);
        if (!repaired.error.empty()) return {Status::invalid_mesh, Sentence(repaired.error.c_str())};
        Mesh mesh(std::make_unique<Mesh::Data>(std::move(repaired.mesh)).release());
        if (!goes_on(1.0)) return cancelled_shape();
        return mesh;
    });
}

const char* shape_name(std::size_t i) noexcept
{
    return answer_or(static_cast<const char*>(nullptr), [&] {
        const std::vector<std::string>& names = core::shapes::names();
        return i < names.size() ? names[i].c_str() : nullptr;
    });
}

struct HardSection::Data
{
    core::shapes::HardSection section;
};

HardSection::HardSection(HardSection&& other) noexcept : data_(std::exchange(other.data_, nullptr)) {}

HardSection& HardSection::operator=(HardSection&& other) noexcept
{
    HardSection taken(std::move(other));
    std::swap(data_, taken.data_);
    return *this;
}

HardSection::~HardSection()
{
    delete data_;
}

MeshInput HardSection::input() const noexcept
{
    MeshInput input;
    if (data_ == nullptr) return input;
    const core::TriangleSoup& soup = data_->section.soup;
    input.positions = &soup.vertices[0].position.x;
    input.position_stride = input.normal_stride = input.uv_stride = sizeof(core::Vertex);
    input.vertex_count = soup.vertices.size();
    if (soup.has_normals) input.normals = &soup.vertices[0].normal.x;
    input.uvs = &soup.vertices[0].uv.x;
    input.indices = soup.triangles[0].data();
    input.triangle_count = soup.triangles.size();
    return input;
}

Plane HardSection::plane() const noexcept
{
    const core::Plane plane = data_ != nullptr ? data_->section.plane : core::Plane();
    return Plane::from_coefficients(plane.normal.x, plane.normal.y, plane.normal.z, -plane.offset).value();
}

Result<HardSection> make_hard_section(const char* name, std::uint32_t size) noexcept
{
    return result_of<HardSection>("there is not enough memory for the section", [&]() -> Result<HardSection> {
        std::optional<core::shapes::HardSection> made = core::shapes::hard_section(name != nullptr ? name : "", size);
        if (!made)
            return {Status::invalid_argument, Sentence("there is no such section; hard_section_name() lists them")};
        auto data = std::make_unique<HardSection::Data>();
        data->section = *std::move(made);
        return HardSection(data.release());
    });
}

const char* hard_section_name(std::size_t i) noexcept
{
    return answer_or(static_cast<const char*>(nullptr), [&] {
        const std::vector<std::string>& names = core::shapes::hard_section_names();
        return i < names.size() ? names[i].c_str() : nullptr;
    });
}

}  // namespace kerf
