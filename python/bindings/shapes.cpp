#include "answers.h"
#include "bindings.h"

#include <kerf/shapes.h>

#include <optional>
#include <string>

namespace py = pybind11;

namespace kerf::python {

namespace {

Mesh shape(const std::string& name, std::uint64_t triangles, std::uint64_t seed)
{
    Interruptible interruptible;
    ShapeOptions options;
    options.seed = seed;
    options.progress = &Interruptible::progress;
    options.user = &interruptible;
    std::optional<Result<Mesh>> mesh;
    {
        const py::gil_scoped_release unlocked;
        mesh.emplace(make_shape(name.c_str(), triangles, options));
    }
    interruptible.rethrow();
    return value_of(std::move(*mesh));
}

}  // namespace

void bind_shapes(py::module_& module)
{
    module.def("shape", &shape, py::arg("name"), py::arg("triangles"), py::arg("seed"));
    module.def("shape_names", [] {
        py::list names;
        for (std::size_t i = 0; shape_name(i) != nullptr; ++i) names.append(shape_name(i));
        return names;
    });
}

}  // namespace kerf::python
