#include "bench/peers/peer_inputs.h"

#include <stdexcept>
#include <utility>

#include "baseline/baseline.h"
#include "bench/models.h"
#include "bench/timed_shapes.h"
#include "common/cutting/cut.h"

namespace kerf::bench {

namespace {

PeerInput input_of(const std::string& name, const ProvenMesh& mesh, std::vector<Plane> planes)
{
    PeerInput input;
    input.name = name;
    input.points.resize(mesh->point_count);
    for (std::size_t v = 0; v < mesh->vertices.size(); ++v) input.points[mesh->points[v]] = mesh->vertices[v].position;
    for (const Triangle& t : mesh->triangles)
        input.triangles.push_back({mesh->points[t[0]], mesh->points[t[1]], mesh->points[t[2]]});
    input.planes = std::move(planes);

    const auto backend = baseline::make_back_end(baseline::VertexLookup::remap);
    const PrepareResult prepared = backend->prepare(mesh);
    if (!prepared.object) throw std::runtime_error(name + ": " + prepared.reason);
    input.volume = prepared.object->mass_properties().volume;
    for (const Plane& plane : input.planes) {
        const CutResult result = cut(prepared.object->clone(), plane);
        if (result.status != Status::done)
            throw std::runtime_error(name + ": a plane gives " + std::string(name_of(result.status)));
        input.volumes.push_back(result.negative.front()->mass_properties().volume);
    }
    return input;
}

}  // namespace

PeerInput asteroid_input(std::uint64_t triangles)
{
    const ProvenMesh& mesh = timed_shape("asteroid", triangles);
    return input_of("asteroid", mesh, planes_of_shape(mesh));
}

std::vector<PeerInput> model_inputs()
{
    std::vector<PeerInput> inputs;
    for (const Model& model : models()) inputs.push_back(input_of(model.name, model.mesh, planes_of_model(model)));
    return inputs;
}

}  // namespace kerf::bench
