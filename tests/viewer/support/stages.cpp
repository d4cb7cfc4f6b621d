#include "viewer/support/stages.h"

#include <kerf/shapes.h>
#include <algorithm>

#include <glm/common.hpp>

#include "viewer/sim/back_ends.h"

namespace kerf::test {

Mesh shape(const std::string& name, std::uint64_t triangles, std::uint64_t seed)
{
    ShapeOptions options;
    options.seed = seed;
    return value_of(make_shape(name.c_str(), triangles, options));
}

MeshInput input_of(const Mesh& mesh)
{
    const MeshArrays arrays = mesh.arrays();
    MeshInput input;
    input.positions = &arrays.positions.front().x;
    input.vertex_count = arrays.positions.size();
    input.indices = arrays.indices.data();
    input.triangle_count = arrays.indices.size() / 3;
    input.normals = &arrays.normals.front().x;
    input.uvs = &arrays.uvs.front().x;
    return input;
}

Object object_of(const Mesh& mesh, const std::string& backend)
{
    return value_of(sim::prepare(mesh, backend));
}

DrawView view_of(const Object& object)
{
    DrawView view;
    if (const Status status = object.draw(view); !ok(status)) throw std::runtime_error(text(status));
    return view;
}

Plane plane_through(const glm::dvec3& point, const glm::dvec3& normal)
{
    return Plane::at(Point(point), Normal(normal)).value();
}

std::shared_ptr<sim::ModelLibrary> library_of(const std::vector<std::string>& shapes, std::uint64_t triangles)
{
    auto library = std::make_shared<sim::ModelLibrary>();
    for (const std::string& name : shapes) library->add(name, shape(name, triangles));
    return library;
}

std::shared_ptr<sim::ModelLibrary> report_library()
{
    auto library = std::make_shared<sim::ModelLibrary>();
    library->add_report_models(KERF_DATA_DIR "/models");
    return library;
}

std::vector<sim::InputEvent> stroke(sim::Microseconds start, sim::Microseconds duration, const glm::dvec2& from,
                                    const glm::dvec2& to, sim::Microseconds step)
{
    std::vector<sim::InputEvent> events{{start, sim::InputKind::press, from, {}}};
    for (sim::Microseconds t = step; t < duration; t += step)
        events.push_back({start + t, sim::InputKind::move, glm::mix(from, to, double(t) / double(duration)), {}});
    events.push_back({start + duration, sim::InputKind::release, to, {}});
    return events;
}

std::string back_end_test_name(const testing::TestParamInfo<std::string>& backend)
{
    std::string name = backend.param;
    std::replace(name.begin(), name.end(), '/', '_');
    return name;
}

}  // namespace kerf::test
