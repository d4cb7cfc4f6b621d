#include "answers.h"
#include "bindings.h"
#include "facts.h"

#include <kerf/io.h>

#include <optional>
#include <string>

#include <pybind11/stl.h>

namespace py = pybind11;

namespace kerf::python {

namespace {

/// The mesh, its report, and notes: what was put right in the file, and how often.
py::tuple with_report(Result<Mesh>&& mesh, const FileReport& report)
{
    py::list notes;
    for (std::size_t i = 0; i < report.note_count(); ++i)
        notes.append(py::make_tuple(report.note(i).what, report.note(i).count));
    return py::make_tuple(value_of(std::move(mesh)), report_tuple(report.mesh()), notes);
}

py::tuple read_file(const std::string& path)
{
    FileReport report;
    std::optional<Result<Mesh>> mesh;
    {
        const py::gil_scoped_release unlocked;
        mesh.emplace(read_mesh(path.c_str(), &report));
    }
    return with_report(std::move(*mesh), report);
}

/// The library calls a file in memory by its format: "memory.stl: ".
std::string without_name(const char* reason, const std::string& format)
{
    const std::string name = "memory." + format + ": ", text = reason;
    return text.starts_with(name) ? text.substr(name.size()) : text;
}

py::tuple read_bytes(const py::bytes& file, const std::string& format)
{
    const std::string_view bytes = file;
    FileReport report;
    std::optional<Result<Mesh>> mesh;
    {
        const py::gil_scoped_release unlocked;
        mesh.emplace(read_mesh(std::as_bytes(std::span(bytes.data(), bytes.size())), format.c_str(), &report));
    }
    if (!*mesh) raise(mesh->status(), without_name(mesh->reason(), format).c_str());
    return with_report(std::move(*mesh), report);
}

void write_file(const Mesh& mesh, const std::string& path)
{
    std::optional<Outcome> outcome;
    {
        const py::gil_scoped_release unlocked;
        outcome.emplace(write_mesh(mesh, path.c_str()));
    }
    check(*outcome);
}

py::bytes file_bytes(const Mesh& mesh, const std::string& format)
{
    std::optional<Result<FileBytes>> file;
    {
        const py::gil_scoped_release unlocked;
        file.emplace(mesh_file_bytes(mesh, format.c_str()));
    }
    const FileBytes bytes = value_of(std::move(*file));
    return py::bytes(reinterpret_cast<const char*>(bytes.bytes().data()), bytes.bytes().size());
}

/// All names that `name(i)` answers, up to the null.
py::list names(const char* (*name)(std::size_t))
{
    py::list result;
    for (std::size_t i = 0; name(i) != nullptr; ++i) result.append(name(i));
    return result;
}

}  // namespace

void bind_files(py::module_& module)
{
    module.def("read_file", &read_file, py::arg("path"));
    module.def("read_bytes", &read_bytes, py::arg("file"), py::arg("format"));
    module.def("write_file", &write_file, py::arg("mesh"), py::arg("path"));
    module.def("file_bytes", &file_bytes, py::arg("mesh"), py::arg("format"));
    module.def("readable_formats", [] { return names(&readable_format); });
    module.def("writable_formats", [] { return names(&writable_format); });
}

}  // namespace kerf::python
