#include "bindings.h"

PYBIND11_MODULE(_core, module)
{
    module.doc() = "The C++ library, as the package kerf calls it.";
    kerf::python::bind_answers(module);
    kerf::python::bind_numbers(module);
    kerf::python::bind_meshes(module);
    kerf::python::bind_files(module);
    kerf::python::bind_shapes(module);
    kerf::python::bind_objects(module);
    kerf::python::bind_cuts(module);
    kerf::python::bind_fractures(module);
    kerf::python::bind_sections(module);
}
