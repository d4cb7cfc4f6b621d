#include "answers.h"
#include "arrays.h"
#include "bindings.h"
#include "objects.h"
#include "triples.h"

#include <kerf/fracture.h>

#include <optional>
#include <utility>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

namespace py = pybind11;

namespace kerf::python {

namespace {

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// What Python gives of FractureOptions.
FractureOptions fracture_options(int pattern, std::uint32_t cells, std::uint64_t seed, const std::optional<Triple>& at,
                                 const Triple& direction, double least_volume, std::uint32_t material, double uv_scale)
{
    FractureOptions options;
    options.pattern = static_cast<FracturePattern>(pattern);
    options.cells = cells;
    options.seed = seed;
    if (at) options.at = Point(vector(*at));
    options.direction = Normal(vector(direction));
    options.least_volume = least_volume;
    options.material = material;
    options.uv_scale = uv_scale;
    return options;
}

py::array_t<double> rows_of(const std::vector<Vec3d>& vectors)
{
    py::array_t<double> rows({static_cast<py::ssize_t>(vectors.size()), py::ssize_t{3}});
    auto place = rows.mutable_unchecked<2>();
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        const auto row = static_cast<py::ssize_t>(i);
        place(row, 0) = vectors[i].x;
        place(row, 1) = vectors[i].y;
        place(row, 2) = vectors[i].z;
    }
    return rows;
}

/// Breaks an object, which stays as it is.
py::dict fracture_object(const SharedObject& shared, FractureOptions options, const std::optional<Rows>& sites)
{
    std::vector<Vec3d> given;
    if (sites)
        for (py::ssize_t i = 0; i < sites->shape(0); ++i)
            given.emplace_back(sites->at(i, 0), sites->at(i, 1), sites->at(i, 2));
    options.sites = given;
    Interruptible interruptible;
    options.progress = &Interruptible::progress;
    options.user = &interruptible;
    Fracture fracture = shared.read([&](const Object& object) { return kerf::fracture(object, options); });
    interruptible.rethrow();
    if (!ok(fracture.status())) raise(fracture.status(), fracture.reason());

    py::list pieces;
    for (std::size_t i = 0; Object* piece = fracture.piece(i); ++i) {
        py::tuple cells(fracture.cells(i).size());
        for (std::size_t c = 0; c < fracture.cells(i).size(); ++c) cells[c] = fracture.cells(i)[c];
        pieces.append(py::make_tuple(share(std::move(*piece)), cells));
    }
    const std::span<const FractureBond> bonds = fracture.bonds();
    py::array_t<std::uint32_t> pairs({static_cast<py::ssize_t>(bonds.size()), py::ssize_t{2}});
    py::array_t<double> areas(static_cast<py::ssize_t>(bonds.size()));
    std::vector<Vec3d> centres, normals;
    for (std::size_t i = 0; i < bonds.size(); ++i) {
        const auto row = static_cast<py::ssize_t>(i);
        pairs.mutable_at(row, 0) = bonds[i].first;
        pairs.mutable_at(row, 1) = bonds[i].second;
        areas.mutable_at(row) = bonds[i].area;
        centres.push_back(bonds[i].centre);
        normals.push_back(bonds[i].normal);
    }
    py::dict result;
    result["pieces"] = pieces;
    result["pairs"] = pairs;
    result["areas"] = areas;
    result["centres"] = rows_of(centres);
    result["normals"] = rows_of(normals);
    result["sites"] = rows_of({fracture.sites().begin(), fracture.sites().end()});
    return result;
}

}  // namespace

void bind_fractures(py::module_& module)
{
    py::class_<FractureOptions>(module, "FractureOptions")
        .def(py::init(&fracture_options), py::arg("pattern"), py::arg("cells"), py::arg("seed"), py::arg("at"),
             py::arg("direction"), py::arg("least_volume"), py::arg("material"), py::arg("uv_scale"));
    module.def("fracture", &fracture_object, py::arg("object"), py::arg("options"), py::arg("sites"));
}

}  // namespace kerf::python
