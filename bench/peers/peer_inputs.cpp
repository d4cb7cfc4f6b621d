#include "bench/peers/peer_inputs.h"

#include <kerf/cut.h>
#include <kerf/section.h>

#include <stdexcept>
#include <utility>

#include "baseline/report_back_ends.h"
#include "bench/models.h"
#include "bench/objects.h"
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
    const Mesh& mesh = timed_shape("asteroid", triangles);
    SectionInput input{bare("asteroid", mesh), planes_of_shape(mesh), {}, mesh.bounds().lo.z, mesh.bounds().hi.z};
    const Object prepared = prepared_linear(input.name, mesh);
    for (const Plane& plane : input.planes) {
        const Section found = section(prepared, plane);
        if (found.status != Status::done) throw std::runtime_error(std::string("a plane gives ") + text(found.status));
        input.expected.push_back({found.length, found.path_count()});
    }
    return input;
}

}  // namespace kerf::bench
