#include "answers.h"
#include "arrays.h"
#include "bindings.h"
#include "facts.h"
#include "objects.h"
#include "triples.h"

#include <kerf/drawing.h>
#include <kerf/section.h>

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace kerf::python {

namespace {

/// A section of its own, or one of a stack, which it keeps.
struct SharedSection
{
    std::shared_ptr<const Section> section;

    const Section& operator*() const { return *section; }
    const Section* operator->() const { return section.get(); }
    py::capsule owner() const { return hold(std::shared_ptr<const void>(section)); }
};

SectionOptions section_options(bool nesting, bool fill, bool delaunay, bool attributes, const std::optional<Triple>& up)
{
    SectionOptions options;
    options.nesting = nesting;
    options.fill = fill;
    options.fill_quality = delaunay ? CapQuality::delaunay : CapQuality::fast;
    options.attributes = attributes;
    if (up) options.up = vector(*up);
    return options;
}

SharedSection find_section(const SharedObject& shared, const Plane& plane, const SectionOptions& options)
{
    const auto found = std::make_shared<Section>();
    const Status status = shared.read([&](const Object& object) { return section(object, plane, *found, options); });
    if (!ok(status) && status != Status::missed) raise(status, found->reason());
    return {found};
}

std::shared_ptr<SectionStack> find_sections(const SharedObject& shared, const Triple& normal,
                                            const std::vector<double>& heights, const SectionOptions& section,
                                            std::uint32_t threads)
{
    Interruptible interruptible;
    StackOptions options;
    options.section = section;
    options.threads = threads;
    options.progress = &Interruptible::progress;
    options.user = &interruptible;
    const auto stack = std::make_shared<SectionStack>();
    const Status status = shared.read(
        [&](const Object& object) { return sections(object, Normal(vector(normal)), heights, *stack, options); });
    interruptible.rethrow();
    if (status != Status::done) raise(status, stack->reason());
    return stack;
}

py::dict frame(const SharedSection& shared)
{
    const SectionFrame& frame = shared->frame;
    py::dict result;
    result["origin"] = small_array(frame.origin);
    result["x"] = small_array(frame.x);
    result["y"] = small_array(frame.y);
    result["normal"] = small_array(frame.normal);
    return result;
}

/// One of the members of SectionEdge, of which all stand in one array.
py::array edge_numbers(const std::span<const SectionEdge>& edges, const std::uint32_t SectionEdge::*member,
                       const py::dtype& type, const py::capsule& owner)
{
    return view(type, edges.empty() ? nullptr : &(edges.front().*member), edges.size(), 0, sizeof(SectionEdge), owner);
}

/// Of the ends of edges, which stand in one array, too.
template <class T>
py::array end_numbers(std::span<const DrawVertex> ends, const T DrawVertex::*member, std::size_t width,
                      const py::capsule& owner)
{
    return view(py::dtype::of<float>(), ends.empty() ? nullptr : &(ends.front().*member), ends.size(), width,
                sizeof(DrawVertex), owner);
}

py::dict path(const SharedSection& shared, std::size_t i)
{
    const SectionPath path = shared->path(i);
    const py::capsule owner = shared.owner();
    py::dict result;
    result["points"] = view(path.points, owner);
    result["face_index"] = edge_numbers(path.edges, &SectionEdge::source, py::dtype::of<std::int32_t>(), owner);
    result["material"] = edge_numbers(path.edges, &SectionEdge::material, py::dtype::of<std::uint32_t>(), owner);
    result["end_normals"] = end_numbers(path.ends, &DrawVertex::normal, 3, owner);
    result["end_uv"] = end_numbers(path.ends, &DrawVertex::uv, 2, owner);
    result["area"] = path.area;
    result["length"] = path.length;
    result["parent"] = path.parent == kNone ? -1 : static_cast<std::int64_t>(path.parent);
    result["solid"] = path.solid;
    result["is_closed"] = path.is_closed;
    py::dict streams;
    for (std::size_t s = 0; s < shared->stream_count(); ++s) {
        const Stream stream = shared->stream(s);
        const std::size_t first = 2 * path.first_edge * stream.width;
        const std::size_t count = 2 * path.edges.size() * stream.width;
        streams[py::str(stream.name)] = view(stream.values.subspan(first, count), stream.width, owner);
    }
    result["end_attributes"] = streams;
    return result;
}

DrawingOptions drawing_options(const std::string& unit)
{
    DrawingOptions options;
    for (const LengthUnit known :
         {LengthUnit::millimetre, LengthUnit::centimetre, LengthUnit::metre, LengthUnit::inch, LengthUnit::foot}) {
        if (unit != text(known)) continue;
        options.unit = known;
        return options;
    }
    throw py::value_error("unit: mm, cm, m, in or ft expected, got '" + unit + "'");
}

void write(std::span<const Section> sections, const std::string& path, const std::string& unit)
{
    const DrawingOptions options = drawing_options(unit);
    std::optional<Outcome> outcome;
    {
        const py::gil_scoped_release unlocked;
        outcome.emplace(write_drawing(sections, path.c_str(), options));
    }
    check(*outcome);
}

py::bytes bytes(std::span<const Section> sections, const std::string& format, const std::string& unit)
{
    const DrawingOptions options = drawing_options(unit);
    std::optional<Result<FileBytes>> file;
    {
        const py::gil_scoped_release unlocked;
        file.emplace(drawing_bytes(sections, format.c_str(), options));
    }
    const FileBytes drawn = value_of(std::move(*file));
    return py::bytes(reinterpret_cast<const char*>(drawn.bytes().data()), drawn.bytes().size());
}

}  // namespace

void bind_sections(py::module_& module)
{
    py::class_<SectionOptions>(module, "SectionOptions")
        .def(py::init(&section_options), py::arg("nesting"), py::arg("fill"), py::arg("delaunay"),
             py::arg("attributes"), py::arg("up"));
    py::class_<SharedSection>(module, "Section")
        .def_property_readonly("status", [](const SharedSection& s) { return static_cast<int>(s->status); })
        .def_property_readonly("is_positive",
                               [](const SharedSection& s) { return s->side_of_object == Side::positive; })
        .def_property_readonly("area", [](const SharedSection& s) { return s->area; })
        .def_property_readonly("length", [](const SharedSection& s) { return s->length; })
        .def_property_readonly("centroid", [](const SharedSection& s) { return small_array(s->centroid); })
        .def_property_readonly("bounds", [](const SharedSection& s) { return small_array(s->bounds); })
        .def_property_readonly("frame", &frame)
        .def_property_readonly("fill_exceeds_section", [](const SharedSection& s) { return s->fill_exceeds_section; })
        .def_property_readonly("statistics", [](const SharedSection& s) { return statistics_dict(s->statistics()); })
        .def_property_readonly("path_count", [](const SharedSection& s) { return s->path_count(); })
        .def_property_readonly("points", [](const SharedSection& s) { return view(s->points(), s.owner()); })
        .def_property_readonly("triangles", [](const SharedSection& s) { return view(s->triangles(), 3, s.owner()); })
        .def("path", &path, py::arg("i"))
        .def("write",
             [](const SharedSection& s, const std::string& path, const std::string& unit) {
                 write({s.section.get(), 1}, path, unit);
             })
        .def("bytes", [](const SharedSection& s, const std::string& format, const std::string& unit) {
            return bytes({s.section.get(), 1}, format, unit);
        });
    py::class_<SectionStack, std::shared_ptr<SectionStack>>(module, "SectionStack")
        .def_property_readonly("count", [](const SectionStack& stack) { return stack.all().size(); })
        .def("section",
             [](const std::shared_ptr<SectionStack>& stack, std::size_t i) {
                 if (i >= stack->all().size()) throw py::index_error("there are fewer sections");
                 return SharedSection{{stack, &stack->all()[i]}};
             })
        .def("write", [](const SectionStack& stack, const std::string& path,
                         const std::string& unit) { write(stack.all(), path, unit); })
        .def("bytes", [](const SectionStack& stack, const std::string& format, const std::string& unit) {
            return bytes(stack.all(), format, unit);
        });
    module.def("section", &find_section, py::arg("object"), py::arg("plane"), py::arg("options"));
    module.def("sections", &find_sections, py::arg("object"), py::arg("normal"), py::arg("heights"), py::arg("options"),
               py::arg("threads"));
    module.def(
        "sooner_for_sections",
        [](const Mesh& mesh, const Triple& normal, const std::vector<double>& heights) {
            return quicker_for_sections(mesh, Normal(vector(normal)), heights) == BackEnd::halfedge;
        },
        py::arg("mesh"), py::arg("normal"), py::arg("heights"));
}

}  // namespace kerf::python
