#pragma once

#include <kerf/io.h>
#include <kerf/object.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

// Files as the program uses them: what goes wrong is an exception with the library's sentence.

namespace kerf::tools {

/// A file that cannot be used. what() names it.
class FileError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// A mesh file that was read.
struct LoadedFile
{
    Mesh mesh;
    FileReport report;

    const MeshFacts& facts() const { return report.mesh().facts; }
    const Repairs& repairs() const { return report.mesh().repairs; }
};

/// @throws FileError
inline LoadedFile load(const std::string& path)
{
    LoadedFile file;
    Result<Mesh> mesh = read_mesh(path.c_str(), &file.report);
    if (!mesh) throw FileError(mesh.reason());
    file.mesh = *std::move(mesh);
    return file;
}

/// What can be written, the default first.
inline std::vector<std::string> writable_formats()
{
    std::vector<std::string> formats;
    for (std::size_t i = 0; const char* format = writable_format(i); ++i) formats.emplace_back(format);
    return formats;
}

/// @throws FileError
inline void check(const Outcome& outcome)
{
    if (!outcome) throw FileError(outcome.reason());
}

/// The mesh of an object. @throws std::runtime_error
inline Mesh mesh_of(const Object& object)
{
    Result<Mesh> mesh = object.mesh();
    if (!mesh) throw std::runtime_error(mesh.reason());
    return *std::move(mesh);
}

}  // namespace kerf::tools
