#include "objects.h"

#include "answers.h"
#include "bindings.h"
#include "facts.h"

#include <optional>
#include <string>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace kerf::python {

namespace {

std::shared_ptr<SharedObject> prepare_mesh(const Mesh& mesh, const std::optional<std::string>& back_end,
                                           std::uint32_t cuts_expected, std::uint32_t cuts_with_room,
                                           std::uint32_t threads)
{
    Interruptible interruptible;
    PrepareOptions options;
    if (back_end) options.back_end_name = back_end->c_str();
    options.cuts_expected = cuts_expected;
    options.cuts_with_room = cuts_with_room;
    options.threads = threads;
    options.progress = &Interruptible::progress;
    options.user = &interruptible;
    std::optional<Result<Object>> object;
    {
        const py::gil_scoped_release unlocked;
        object.emplace(prepare(Mesh(mesh), options));
    }
    interruptible.rethrow();
    return share(value_of(std::move(*object)));
}

py::list back_ends()
{
    py::list names;
    for (std::size_t i = 0; i < back_end_count(); ++i) names.append(back_end(i).name);
    return names;
}

py::list materials_of(const SharedObject& shared)
{
    const auto looks = shared.read([](const Object& object) {
        std::vector<std::tuple<std::string, std::array<float, 4>, std::string>> found;
        for (std::size_t i = 0; i < object.material_count(); ++i) {
            const Material material = object.material(i);
            const float* const colour = material.base_colour;
            found.emplace_back(material.name, std::array{colour[0], colour[1], colour[2], colour[3]},
                               material.base_colour_image);
        }
        return found;
    });
    py::list materials;
    for (const auto& [name, colour, image] : looks)
        materials.append(py::make_tuple(name, py::make_tuple(colour[0], colour[1], colour[2], colour[3]), image));
    return materials;
}

std::uint32_t add_material(SharedObject& shared, const std::string& name, const std::array<float, 4>& colour,
                           const std::string& image)
{
    Material material;
    material.name = name.c_str();
    std::copy(colour.begin(), colour.end(), material.base_colour);
    material.base_colour_image = image.c_str();
    const std::uint32_t number = shared.change([&](Object& object) { return object.add_material(material); });
    if (number == kNone) raise(Status::out_of_memory, "");
    return number;
}

}  // namespace

void bind_objects(py::module_& module)
{
    module.def("prepare", &prepare_mesh, py::arg("mesh"), py::arg("back_end"), py::arg("cuts_expected"),
               py::arg("cuts_with_room"), py::arg("threads"));
    module.def("back_ends", &back_ends);
    py::class_<SharedObject, std::shared_ptr<SharedObject>>(module, "Object")
        .def_property_readonly("is_gone", &SharedObject::is_gone)
        .def_property_readonly(
            "triangle_count",
            [](const SharedObject& shared) { return shared.read([](const Object& o) { return o.triangle_count(); }); })
        .def_property_readonly("bounds",
                               [](const SharedObject& shared) {
                                   return small_array(shared.read([](const Object& o) { return o.bounds(); }));
                               })
        .def_property_readonly("mass",
                               [](const SharedObject& shared) {
                                   return mass_dict(shared.read([](const Object& o) { return o.mass_properties(); }));
                               })
        .def_property_readonly("back_end",
                               [](const SharedObject& shared) {
                                   return shared.read([](const Object& o) { return std::string(o.back_end_name()); });
                               })
        .def_property_readonly("materials", &materials_of)
        .def("add_material", &add_material, py::arg("name"), py::arg("colour"), py::arg("image"))
        .def("mesh",
             [](const SharedObject& shared) { return value_of(shared.read([](const Object& o) { return o.mesh(); })); })
        .def("clone", [](const SharedObject& shared) {
            return share(value_of(shared.read([](const Object& o) { return o.clone(); })));
        });
}

}  // namespace kerf::python
