#include "answers.h"

#include "bindings.h"

#include <kerf/version.h>

namespace py = pybind11;

namespace kerf::python {

namespace {

/// kerf.FileError, which lives as long as the interpreter.
PyObject* file_error = nullptr;

}  // namespace

void raise(Status status, const char* reason)
{
    switch (status) {
        case Status::out_of_memory:
            PyErr_SetString(PyExc_MemoryError, "there is not enough memory");
            break;
        case Status::unusable_file:
            PyErr_SetString(file_error, reason);
            break;
        default:
            PyErr_SetString(PyExc_ValueError, reason);
            break;
    }
    throw py::error_already_set();
}

bool Interruptible::progress(void* user, double) noexcept
{
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() == 0) return true;
    static_cast<Interruptible*>(user)->raised_ = std::make_exception_ptr(py::error_already_set());
    return false;
}

void bind_answers(py::module_& module)
{
    file_error = PyErr_NewExceptionWithDoc(
        "kerf.FileError", "A file that can't be read or written; its sentence names the file and the fault.",
        PyExc_OSError, nullptr);
    module.add_object("FileError", py::reinterpret_borrow<py::object>(file_error));
    module.def("version", &version);
    module.def("bits_version", &bits_version);
    module.def("status_names", [] {
        py::list names;
        for (int i = 0; i <= static_cast<int>(Status::not_separated); ++i) names.append(text(static_cast<Status>(i)));
        return names;
    });
}

}  // namespace kerf::python
