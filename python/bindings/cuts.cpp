#include "answers.h"
#include "bindings.h"
#include "facts.h"
#include "objects.h"
#include "triples.h"

#include <kerf/cut.h>
#include <kerf/dice.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace kerf::python {

namespace {

/// What Python gives of CutOptions.
CutOptions cut_options(bool cap, bool components, std::uint32_t cap_material, double cap_uv_scale, double gap,
                       bool delaunay, const std::optional<Triple>& only, bool only_solid)
{
    CutOptions options;
    options.cap = cap;
    options.components = components;
    options.cap_material = cap_material;
    options.cap_uv_scale = cap_uv_scale;
    options.gap = gap;
    options.cap_quality = delaunay ? CapQuality::delaunay : CapQuality::fast;
    if (only) options.only = {vector(*only), only_solid ? OnlyNear::Extent::solid : OnlyNear::Extent::region};
    return options;
}

/// Row by row, as NumPy has it.
Mat4d matrix(const py::array_t<double, py::array::c_style | py::array::forcecast>& rows)
{
    if (rows.ndim() != 2 || rows.shape(0) != 4 || rows.shape(1) != 4)
        throw py::value_error("transform: a 4x4 matrix expected");
    Mat4d result;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column) result.m[column][row] = rows.at(row, column);
    return result;
}

Plane plane_at(const Triple& point, const Triple& normal)
{
    const std::optional<Plane> plane = Plane::at(Point(vector(point)), Normal(vector(normal)));
    if (!plane) throw py::value_error("origin and normal are no plane: the numbers must be finite, the normal not 0");
    return *plane;
}

Plane to_local(const Plane& plane, const py::array_t<double, py::array::c_style | py::array::forcecast>& rows)
{
    const std::optional<Plane> local = plane.to_local(matrix(rows));
    if (!local) throw py::value_error("transform: no matrix of an affine map that can be undone");
    return *local;
}

py::list pieces_of(Cut& cut, Side side)
{
    py::list pieces;
    for (std::size_t i = 0; Object* piece = cut.piece(side, i); ++i) pieces.append(share(std::move(*piece)));
    return pieces;
}

/// Cuts an object, which is gone then, unless nothing was cut.
py::dict cut_object(SharedObject& shared, const Plane& plane, const CutOptions& options)
{
    Cut cut = shared.change([&](Object& object) {
        Cut made = kerf::cut(std::move(object), plane, options);
        if (made.object) object = std::move(made.object);
        return made;
    });
    if (cut.status == Status::invalid_argument || cut.status == Status::out_of_memory) raise(cut.status, cut.reason());
    py::dict result;
    result["status"] = static_cast<int>(cut.status);
    result["is_positive"] = cut.side_of_object == Side::positive;
    result["positive"] = pieces_of(cut, Side::positive);
    result["negative"] = pieces_of(cut, Side::negative);
    result["area"] = cut.section_area;
    result["caps_exceed_section"] = cut.caps_exceed_section;
    result["statistics"] = statistics_dict(cut.statistics());
    return result;
}

using Layers = std::vector<std::pair<Triple, std::vector<double>>>;

std::vector<DicePlanes> dice_planes(const Layers& layers)
{
    std::vector<DicePlanes> planes;
    for (const auto& [normal, heights] : layers) planes.push_back({Normal(vector(normal)), heights});
    return planes;
}

/// Dices an object, which is gone then.
py::dict dice_object(SharedObject& shared, const Layers& layers, const CutOptions& cut)
{
    const std::vector<DicePlanes> planes = dice_planes(layers);
    Interruptible interruptible;
    DiceOptions options;
    options.cut = cut;
    options.progress = &Interruptible::progress;
    options.user = &interruptible;
    Dice dice = shared.change([&](Object& object) { return kerf::dice(std::move(object), planes, options); });
    interruptible.rethrow();
    if (!ok(dice.status())) raise(dice.status(), dice.reason());
    py::list pieces;
    for (std::size_t i = 0; Object* piece = dice.piece(i); ++i) {
        py::tuple cell(dice.cell(i).size());
        for (std::size_t axis = 0; axis < dice.cell(i).size(); ++axis) cell[axis] = dice.cell(i)[axis];
        pieces.append(py::make_tuple(share(std::move(*piece)), cell));
    }
    py::dict result;
    result["status"] = static_cast<int>(dice.status());
    result["pieces"] = pieces;
    result["empty_cells"] = dice.empty_cells();
    result["caps_exceed_section"] = dice.caps_exceed_section();
    result["statistics"] = statistics_dict(dice.statistics());
    return result;
}

}  // namespace

void bind_cuts(py::module_& module)
{
    py::class_<Plane>(module, "Plane")
        .def(py::init(&plane_at), py::arg("point"), py::arg("normal"))
        .def("to_local", &to_local, py::arg("transform"))
        .def_property_readonly("normal", [](const Plane& plane) { return small_array(plane.normal()); })
        .def_property_readonly("offset", &Plane::offset);
    py::class_<CutOptions>(module, "CutOptions")
        .def(py::init(&cut_options), py::arg("cap"), py::arg("components"), py::arg("cap_material"),
             py::arg("cap_uv_scale"), py::arg("gap"), py::arg("delaunay"), py::arg("only"), py::arg("only_solid"));
    module.def("cut", &cut_object, py::arg("object"), py::arg("plane"), py::arg("options"));
    module.def("dice", &dice_object, py::arg("object"), py::arg("layers"), py::arg("options"));
    module.def(
        "cuts_expected", [](const Layers& layers) { return cuts_expected(dice_planes(layers)); }, py::arg("layers"));
    module.attr("NONE") = kNone;
}

}  // namespace kerf::python
