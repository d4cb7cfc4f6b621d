#include "bindings.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

// Arrays of other types as those that the library takes, in one pass without Python's lock.

namespace py = pybind11;

namespace kerf::python {

namespace {

using Doubles = py::array_t<double, py::array::c_style>;
using Floats = py::array_t<float, py::array::c_style>;
using Integers = py::array_t<std::int64_t, py::array::c_style>;
using Indices = py::array_t<std::uint32_t, py::array::c_style>;

/// Rows minus `origin` as floats, and the longest way that rounding has moved one.
py::tuple rounded_positions(const Doubles& rows, const std::array<double, 3>& origin)
{
    if (rows.ndim() != 2 || rows.shape(1) != 3) throw py::value_error("positions have three coordinates");
    Floats result({rows.shape(0), py::ssize_t{3}});
    const double* from = rows.data();
    float* to = result.mutable_data();
    const py::ssize_t count = rows.shape(0);
    double most = 0.0;
    {
        const py::gil_scoped_release unlocked;
        for (py::ssize_t row = 0; row < count; ++row) {
            double squared = 0.0;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const double place = *from++ - origin[axis];
                *to = static_cast<float>(place);
                const double moved = static_cast<double>(*to++) - place;
                squared += moved * moved;
            }
            // False of what is not finite, which Mesh refuses.
            if (squared > most) most = squared;
        }
    }
    return py::make_tuple(result, std::isfinite(most) ? std::sqrt(most) : std::numeric_limits<double>::infinity());
}

/// The numbers of vertices as the library takes them.
Indices checked_indices(const Integers& rows, std::size_t vertex_count)
{
    if (rows.ndim() != 2 || rows.shape(1) != 3) throw py::value_error("faces have three vertices");
    Indices result({rows.shape(0), py::ssize_t{3}});
    const std::int64_t* from = rows.data();
    std::uint32_t* to = result.mutable_data();
    const py::ssize_t count = 3 * rows.shape(0);
    py::ssize_t wrong = -1;
    {
        const py::gil_scoped_release unlocked;
        for (py::ssize_t i = 0; i < count; ++i) {
            // A negative one is a large one here.
            if (static_cast<std::uint64_t>(from[i]) >= vertex_count) {
                wrong = i;
                break;
            }
            to[i] = static_cast<std::uint32_t>(from[i]);
        }
    }
    if (wrong >= 0) {
        std::ostringstream sentence;
        sentence << "faces: row " << wrong / 3 << " names vertex " << from[wrong] << ", but there are " << vertex_count
                 << " vertices";
        throw py::value_error(sentence.str());
    }
    return result;
}

}  // namespace

void bind_numbers(py::module_& module)
{
    module.def("rounded_positions", &rounded_positions, py::arg("rows").noconvert(), py::arg("origin"));
    module.def("checked_indices", &checked_indices, py::arg("rows").noconvert(), py::arg("vertex_count"));
}

}  // namespace kerf::python
