#include "common/io/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <new>
#include <stdexcept>
#include <system_error>

#include "common/io/output_file.h"
#include "common/io/read_formats.h"
#include "common/io/write_formats.h"

namespace kerf::io {

namespace fs = std::filesystem;

namespace {

/// File name extension in lower case, without the dot.
std::string extension_of(const fs::path& path)
{
    std::string extension = path.extension().string();
    if (!extension.empty()) extension.erase(0, 1);
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

using Reader = TriangleSoup (*)(const fs::path&, std::string_view);

Reader reader_for(const fs::path& path)
{
    const std::string extension = extension_of(path);
    if (extension == "obj") return read_obj;
    if (extension == "off") return read_off;
    if (extension == "ply") return read_ply;
    if (extension == "stl") return read_stl;
    if (extension == "gltf" || extension == "glb") return read_gltf;
    fail(path, "the extension is not one of obj, ply, stl, off, gltf, glb; convert the file to one of these");
}

}  // namespace

void fail(const fs::path& path, const std::string& reason)
{
    // A name may hold line ends and what terminals obey; a message is one line.
    std::string name = path.string();
    std::replace_if(
        name.begin(), name.end(), [](unsigned char c) { return std::iscntrl(c) != 0; }, '?');
    throw FileError(name + ": " + reason);
}

std::optional<fs::path> file_beside(const fs::path& path, const std::string& name)
{
    if (name.empty() || name.find('\0') != std::string::npos || name.find_first_of("\\:") != std::string::npos)
        return std::nullopt;
    const fs::path relative(name);
    if (!relative.is_relative() || std::find(relative.begin(), relative.end(), "..") != relative.end())
        return std::nullopt;
    return path.parent_path() / relative;
}

std::string read_bytes(const fs::path& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) fail(path, "there is no such file; look at its name and folder");
    if (error) fail(path, "it cannot be read (" + error.message() + "); look at its name and folder");
    // A device or a pipe has no size to hold a claim against, and may never end.
    if (status.type() != fs::file_type::regular) fail(path, "it is not a regular file; name a mesh file");
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) fail(path, "it cannot be read (" + error.message() + ")");

    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, "it cannot be opened for reading; allow that first");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (file.bad() || static_cast<std::uintmax_t>(file.gcount()) != size)
        fail(path, "it cannot be read to its end; copy it again");
    return bytes;
}

TriangleSoup read_soup(const fs::path& path)
{
    try {
        const Reader reader = reader_for(path);
        const std::string bytes = read_bytes(path);
        if (bytes.empty()) fail(path, "it is empty; export it again");
        return reader(path, bytes);
    } catch (const std::bad_alloc&) {
        fail(path, "there is not enough memory to read it; divide it or free some");
    } catch (const std::length_error&) {
        fail(path, "there is not enough memory to read it; divide it or free some");
    }
}

const std::vector<std::string>& writable_formats()
{
    static const std::vector<std::string> formats{"obj", "ply", "stl", "glb"};
    return formats;
}

struct MeshFileSet::Impl
{
    std::vector<OutputFile> files;
};

MeshFileSet::MeshFileSet() : impl_(std::make_unique<Impl>()) {}
MeshFileSet::~MeshFileSet() = default;

void MeshFileSet::add(const fs::path& path, const IndexedMesh& mesh)
{
    const std::string extension = extension_of(path);
    std::vector<OutputFile>& files = impl_->files;
    try {
        if (extension == "obj") {
            // The materials first: the OBJ file that names them appears last.
            if (needs_mtl(mesh)) {
                files.emplace_back(mtl_path(path));
                write_mtl(files.back(), mesh);
                files.back().finish();
            }
            files.emplace_back(path);
            write_obj(files.back(), mesh);
        } else if (extension == "ply") {
            files.emplace_back(path);
            write_ply(files.back(), mesh);
        } else if (extension == "stl") {
            files.emplace_back(path);
            write_stl(files.back(), mesh);
        } else if (extension == "glb") {
            files.emplace_back(path);
            write_glb(files.back(), mesh);
        } else {
            fail(path, "the extension is not one of obj, ply, stl, glb; choose one of these");
        }
        files.back().finish();
    } catch (const std::bad_alloc&) {
        fail(path, "there is not enough memory to write it; free some");
    }
}

void MeshFileSet::commit()
{
    std::vector<OutputFile>& files = impl_->files;
    std::size_t done = 0;
    try {
        for (; done < files.size(); ++done) files[done].commit();
    } catch (...) {
        for (std::size_t i = 0; i < done; ++i) files[i].withdraw();
        throw;
    }
    files.clear();
}

void write_mesh(const fs::path& path, const IndexedMesh& mesh)
{
    MeshFileSet files;
    files.add(path, mesh);
    files.commit();
}

}  // namespace kerf::io
