#include "answers.h"
#include "arrays.h"
#include "bindings.h"
#include "facts.h"

#include <kerf/mesh.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace kerf::python {

namespace {

using Floats = py::array_t<float, py::array::c_style>;
using Indices = py::array_t<std::uint32_t, py::array::c_style>;

/// A material as Python has it: name, base colour, image.
using MaterialTuple = std::tuple<std::string, std::array<float, 4>, std::string>;

/// Rows of `width` floats, one for each of `count` vertices.
const float* rows_of(const Floats& array, std::size_t count, std::size_t width, const char* what)
{
    if (array.ndim() != 2 || static_cast<std::size_t>(array.shape(0)) != count ||
        static_cast<std::size_t>(array.shape(1)) != width)
        throw py::value_error(std::string(what) + ": one row for each vertex expected");
    return array.data();
}

void set_surface(MeshInput& input, const Floats& positions, const Indices& indices)
{
    if (positions.ndim() != 2 || positions.shape(1) != 3 || indices.ndim() != 2 || indices.shape(1) != 3)
        throw py::value_error("positions and indices have three numbers a row");
    input.positions = positions.data();
    input.vertex_count = static_cast<std::size_t>(positions.shape(0));
    input.indices = indices.data();
    input.triangle_count = static_cast<std::size_t>(indices.shape(0));
}

Mesh make(const Floats& positions, const Indices& indices, const std::optional<Floats>& normals,
          const std::optional<Floats>& uvs, const std::optional<Indices>& triangle_materials,
          const std::vector<MaterialTuple>& materials, const std::vector<std::pair<std::string, Floats>>& streams,
          float crease_degrees)
{
    MeshInput input;
    set_surface(input, positions, indices);
    if (normals) input.normals = rows_of(*normals, input.vertex_count, 3, "normals");
    if (uvs) input.uvs = rows_of(*uvs, input.vertex_count, 2, "uv");
    input.crease_degrees = crease_degrees;
    if (triangle_materials) {
        if (static_cast<std::size_t>(triangle_materials->size()) != input.triangle_count)
            throw py::value_error("face_material: one number for each face expected");
        input.triangle_materials = triangle_materials->data();
    }
    std::vector<Material> looks;
    for (const auto& [name, colour, image] : materials) {
        Material& look = looks.emplace_back();
        look.name = name.c_str();
        std::copy(colour.begin(), colour.end(), look.base_colour);
        look.base_colour_image = image.c_str();
    }
    input.materials = looks;
    std::vector<StreamInput> numbers;
    for (const auto& [name, values] : streams) {
        if (values.ndim() != 2) throw py::value_error(name + ": one row for each vertex expected");
        StreamInput& stream = numbers.emplace_back();
        stream.name = name.c_str();
        stream.width = static_cast<std::uint32_t>(values.shape(1));
        stream.values = rows_of(values, input.vertex_count, stream.width, name.c_str());
    }
    input.streams = numbers;

    std::optional<Result<Mesh>> mesh;
    {
        const py::gil_scoped_release unlocked;
        mesh.emplace(Mesh::make(input));
    }
    return value_of(std::move(*mesh));
}

/// What there is to say of a mesh of these arrays. Apart from making one: to measure takes a tenth of the time.
py::tuple report_of(const Floats& positions, const Indices& indices, const std::optional<Floats>& normals,
                    const std::optional<Floats>& uvs)
{
    MeshInput input;
    set_surface(input, positions, indices);
    if (normals) input.normals = rows_of(*normals, input.vertex_count, 3, "normals");
    if (uvs) input.uvs = rows_of(*uvs, input.vertex_count, 2, "uv");
    MeshReport report;
    {
        const py::gil_scoped_release unlocked;
        static_cast<void>(Mesh::make(input, &report));
    }
    return report_tuple(report);
}

/// For each vertex of a mesh three numbers of vertices of the input, and their weights.
py::tuple origins(const Mesh& mesh, const Floats& positions, const Indices& indices)
{
    MeshInput input;
    set_surface(input, positions, indices);
    std::vector<VertexOrigin> found(mesh.vertex_count());
    Status status;
    {
        const py::gil_scoped_release unlocked;
        status = vertex_origins(mesh, input, found);
    }
    if (status != Status::done) raise(status, "these are not the arrays that the mesh was made of");
    const VertexOrigin* const data = found.data();
    const std::size_t count = found.size();
    const py::capsule owner = hold(std::move(found));
    return py::make_tuple(
        view(py::dtype::of<std::int32_t>(), data != nullptr ? data->vertices : nullptr, count, 3, sizeof(VertexOrigin),
             owner),
        view(py::dtype::of<float>(), data != nullptr ? data->weights : nullptr, count, 3, sizeof(VertexOrigin), owner));
}

MeshArrays arrays_of(const Mesh& mesh)
{
    const py::gil_scoped_release unlocked;
    const MeshArrays arrays = mesh.arrays();
    if (arrays.indices.empty() && mesh.triangle_count() > 0) {
        const py::gil_scoped_acquire locked;
        raise(Status::out_of_memory, "");
    }
    return arrays;
}

/// A property that shows one of the arrays.
template <class Show>
auto shown(Show show)
{
    return [show](const Mesh& mesh) { return show(arrays_of(mesh), hold(Mesh(mesh))); };
}

py::list materials_of(const Mesh& mesh)
{
    py::list materials;
    for (std::size_t i = 0; i < mesh.material_count(); ++i) materials.append(material_tuple(mesh.material(i)));
    return materials;
}

py::list streams_of(const Mesh& mesh)
{
    py::list streams;
    for (std::size_t i = 0; i < mesh.stream_count(); ++i) {
        const Stream stream = mesh.stream(i);
        streams.append(py::make_tuple(stream.name, view(stream.values, stream.width, hold(Mesh(mesh)))));
    }
    return streams;
}

}  // namespace

void bind_meshes(py::module_& module)
{
    py::class_<Mesh>(module, "Mesh")
        .def_static("make", &make, py::arg("positions").noconvert(), py::arg("indices").noconvert(), py::arg("normals"),
                    py::arg("uvs"), py::arg("triangle_materials"), py::arg("materials"), py::arg("streams"),
                    py::arg("crease_degrees"))
        .def_static("report", &report_of, py::arg("positions").noconvert(), py::arg("indices").noconvert(),
                    py::arg("normals"), py::arg("uvs"))
        .def_property_readonly("triangle_count", &Mesh::triangle_count)
        .def_property_readonly("vertex_count", &Mesh::vertex_count)
        .def_property_readonly("is_closed", &Mesh::is_closed)
        .def_property_readonly("has_coarse_coordinates", &Mesh::has_coarse_coordinates)
        .def_property_readonly("bounds", [](const Mesh& mesh) { return small_array(mesh.bounds()); })
        .def_property_readonly("positions", shown([](const MeshArrays& arrays, const py::capsule& owner) {
                                   return view(arrays.positions, owner);
                               }))
        .def_property_readonly("normals", shown([](const MeshArrays& arrays, const py::capsule& owner) {
                                   return view(arrays.normals, owner);
                               }))
        .def_property_readonly(
            "uvs", shown([](const MeshArrays& arrays, const py::capsule& owner) { return view(arrays.uvs, owner); }))
        .def_property_readonly("points", shown([](const MeshArrays& arrays, const py::capsule& owner) {
                                   return view(arrays.points, 0, owner);
                               }))
        .def_property_readonly("indices", shown([](const MeshArrays& arrays, const py::capsule& owner) {
                                   return view(arrays.indices, 3, owner);
                               }))
        .def_property_readonly("sources", shown([](const MeshArrays& arrays, const py::capsule& owner) {
                                   return signed_view(arrays.sources, owner);
                               }))
        .def_property_readonly("is_cap", shown([](const MeshArrays& arrays, const py::capsule& owner) {
                                   static_assert(static_cast<int>(TriangleKind::cap) == 1 && sizeof(TriangleKind) == 1);
                                   return view(py::dtype::of<bool>(), arrays.kinds.data(), arrays.kinds.size(), 0, 1,
                                               owner);
                               }))
        .def_property_readonly("triangle_materials", shown([](const MeshArrays& arrays, const py::capsule& owner) {
                                   return view(arrays.triangle_materials, 0, owner);
                               }))
        .def_property_readonly("solids", shown([](const MeshArrays& arrays, const py::capsule& owner) {
                                   return view(arrays.solids, 0, owner);
                               }))
        .def_property_readonly("materials", &materials_of)
        .def_property_readonly("streams", &streams_of)
        .def("vertex_origins", &origins, py::arg("positions").noconvert(), py::arg("indices").noconvert());
}

}  // namespace kerf::python
