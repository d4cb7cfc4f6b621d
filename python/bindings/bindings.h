#pragma once

#include <pybind11/pybind11.h>

// What the module kerf._core shows of the C++ interface, one function a file. It is thin: arrays and numbers. What people
// call is python/kerf.

namespace kerf::python {

void bind_answers(pybind11::module_& module);
void bind_numbers(pybind11::module_& module);
void bind_meshes(pybind11::module_& module);
void bind_files(pybind11::module_& module);
void bind_shapes(pybind11::module_& module);
void bind_objects(pybind11::module_& module);
void bind_cuts(pybind11::module_& module);
void bind_fractures(pybind11::module_& module);
void bind_sections(pybind11::module_& module);

}  // namespace kerf::python
