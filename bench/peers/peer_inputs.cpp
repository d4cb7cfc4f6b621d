#include "bench/peers/peer_inputs.h"

#include <kerf/cut.h>
#include <kerf/section.h>

#include <array>
#include <span>
#include <stdexcept>
#include <utility>

#include "baseline/report_back_ends.h"
#include "bench/models.h"
#include "bench/objects.h"
#include "bench/real_meshes.h"
#include "bench/timed_shapes.h"

namespace kerf::bench {

namespace {

BareMesh bare(const std::string& name, const Mesh& mesh)
{
    const MeshArrays arrays = mesh.arrays();
    BareMesh input;
    input.name = name;
    input.points.resize(arrays.point_count);
    for (std::size_t v = 0; v < arrays.points.size(); ++v) input.points[arrays.points[v]] = arrays.positions[v];
    for (std::size_t i = 0; i < arrays.indices.size(); i += 3) {
        const auto point = [&](std::size_t corner) { return arrays.points[arrays.indices[i + corner]]; };
        input.triangles.push_back({point(0), point(1), point(2)});
    }
    return input;
}

/// By the loop over all triangles.
Object prepared_linear(const std::string& name, const Mesh& mesh)
{
    add_report_back_ends();
    PrepareOptions options;
    options.back_end_name = "baseline/remap";
    Result<Object> prepared = prepare(mesh, options);
    if (!prepared) throw std::runtime_error(name + ": " + prepared.reason());
    return std::move(*prepared);
}

PeerInput input_of(const std::string& name, const Mesh& mesh, std::vector<Plane> planes)
{
    PeerInput input{bare(name, mesh), std::move(planes), {}, 0.0};
    const Object prepared = prepared_linear(name, mesh);
    input.volume = prepared.mass_properties().volume;
    for (const Plane& plane : input.planes) {
        Cut result = cut(clone_of(prepared), plane);
        if (result.status != Status::done) throw std::runtime_error(name + ": a plane gives " + text(result.status));
        input.volumes.push_back(result.one(Side::negative)->mass_properties().volume);
    }
    return input;
}

SectionInput section_input_of(const std::string& name, const Mesh& mesh, std::span<const std::size_t> stacks)
{
    SectionInput input{bare(name, mesh), planes_of_shape(mesh), {}, {}};
    const Object prepared = prepared_linear(name, mesh);
    for (const Plane& plane : input.planes) {
        const Section found = section(prepared, plane);
        if (!ok(found.status)) throw std::runtime_error(name + ": a plane gives " + text(found.status));
        input.expected.push_back({found.length, found.path_count()});
    }
    for (const std::size_t count : stacks) {
        SectionInput::Stack& stack = input.stacks.emplace_back();
        const double lowest = mesh.bounds().lo.z, step = (mesh.bounds().hi.z - lowest) / double(count);
        for (std::size_t i = 0; i < count; ++i) stack.heights.push_back(lowest + (double(i) + 0.5) * step);
        const SectionStack found = sections(prepared, Normal(0, 0, 1), stack.heights);
        if (found.status() != Status::done) throw std::runtime_error(name + ": " + found.reason());
        for (const Section& one : found.all()) {
            stack.expected.length += one.length;
            stack.expected.loops += one.path_count();
        }
    }
    return input;
}

}  // namespace

PeerInput asteroid_input(std::uint64_t triangles)
{
    const Mesh& mesh = timed_shape("asteroid", triangles);
    return input_of("asteroid", mesh, planes_of_shape(mesh));
}

std::vector<PeerInput> model_inputs()
{
    std::vector<PeerInput> inputs;
    for (const Model& model : models()) inputs.push_back(input_of(model.name, model.mesh, planes_of_model(model)));
    return inputs;
}

SectionInput asteroid_section_input(std::uint64_t triangles)
{
    constexpr std::array<std::size_t, 3> kStacks{10, 100, 1000};
    return section_input_of("asteroid", timed_shape("asteroid", triangles), kStacks);
}

std::size_t real_section_input_count()
{
    return real_meshes().size();
}

SectionInput real_section_input(std::size_t number)
{
    constexpr std::array<std::size_t, 1> kStacks{100};
    const RealMesh real = real_meshes()[number];
    return section_input_of(real.name, mesh_of(real), kStacks);
}

}  // namespace kerf::bench
