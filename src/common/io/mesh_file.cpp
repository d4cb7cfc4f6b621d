#include "common/io/mesh_file.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <new>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "common/files/file_places.h"
#include "common/files/output_file.h"
#include "common/files/read_file.h"
#include "common/io/read_formats.h"
#include "common/io/write_formats.h"

namespace kerf::core::io {

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

using Reader = TriangleSoup (*)(const fs::path&, std::string_view, ReadingNotes&);

/// For messages and as an extension: "memory.ply".
fs::path name_in_memory(std::string_view format)
{
    return "memory." + std::string(format);
}

/// Whether what is being read in this thread is in memory.
thread_local bool is_in_memory = false;

class InMemory
{
public:
    InMemory() : outer_(std::exchange(is_in_memory, true)) {}
    ~InMemory() { is_in_memory = outer_; }
    InMemory(const InMemory&) = delete;
    InMemory& operator=(const InMemory&) = delete;

private:
    bool outer_;
};

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

using Writer = void (*)(ByteSink&, const IndexedMesh&);

/// Of OBJ without a material file.
Writer writer_for(const fs::path& path)
{
    const std::string extension = extension_of(path);
    if (extension == "obj") return [](ByteSink& sink, const IndexedMesh& mesh) { write_obj(sink, mesh, {}); };
    if (extension == "ply") return write_ply;
    if (extension == "stl") return write_stl;
    if (extension == "off") return write_off;
    if (extension == "glb") return write_glb;
    fail(path, "the extension is not one of obj, ply, stl, off, glb; choose one of these");
}

}  // namespace

std::optional<fs::path> file_beside(const fs::path& path, const std::string& name)
{
    if (is_in_memory) return std::nullopt;
    if (name.empty() || name.find('\0') != std::string::npos || name.find_first_of("\\:") != std::string::npos)
        return std::nullopt;
    const fs::path relative(name);
    if (!relative.is_relative() || std::find(relative.begin(), relative.end(), "..") != relative.end())
        return std::nullopt;
    return path.parent_path() / relative;
}

namespace {

/// `bytes` gives the bytes of the file, once it is known that its format can be read.
template <class Bytes>
TriangleSoup read_any(const fs::path& path, Bytes bytes, ReadingNotes* notes)
{
    try {
        const Reader reader = reader_for(path);
        const auto all = bytes();
        if (all.empty()) fail(path, "it is empty; export it again");
        ReadingNotes unheard;
        return reader(path, all, notes != nullptr ? *notes : unheard);
    } catch (const std::bad_alloc&) {
        fail_without_memory(path, "read it; divide it or free some");
    } catch (const std::length_error&) {
        fail_without_memory(path, "read it; divide it or free some");
    }
}

}  // namespace

TriangleSoup read_soup(const fs::path& path, ReadingNotes* notes)
{
    return read_any(
        path, [&] { return read_bytes(path); }, notes);
}

TriangleSoup read_soup(std::string_view bytes, std::string_view format, ReadingNotes* notes)
{
    const InMemory in_memory;
    return read_any(
        name_in_memory(format), [&] { return bytes; }, notes);
}

std::string mesh_bytes(const IndexedMesh& mesh, std::string_view format)
{
    MemorySink sink(name_in_memory(format));
    try {
        if (const std::string fault = check(mesh); !fault.empty()) fail(sink.path(), "it cannot be written: " + fault);
        writer_for(sink.path())(sink, mesh);
        return sink.take();
    } catch (const std::bad_alloc&) {
        fail_without_memory(sink.path(), "write it; free some");
    }
}

const std::vector<std::string>& writable_formats()
{
    static const std::vector<std::string> formats{"obj", "ply", "stl", "off", "glb"};
    return formats;
}

struct MeshFileSet::Impl
{
    std::vector<fs::path> inputs;
    std::vector<OutputFile> files;
    std::map<fs::path, std::size_t> places;  ///< where each of the files appears

    OutputFile& open(const fs::path& path)
    {
        refuse_to_replace(path, inputs);
        OutputFile& file = files.emplace_back(path);
        if (!places.emplace(place_of(path), files.size() - 1).second) fail_for_same_place(path);
        return file;
    }

    /// Lets go of all files but the first `count`.
    void keep(std::size_t count) noexcept
    {
        std::erase_if(places, [&](const auto& place) { return place.second >= count; });
        while (files.size() > count) files.pop_back();
    }
};

MeshFileSet::MeshFileSet(std::vector<fs::path> inputs) : impl_(std::make_unique<Impl>())
{
    impl_->inputs = std::move(inputs);
}

MeshFileSet::~MeshFileSet() = default;

void MeshFileSet::add(const fs::path& path, const IndexedMesh& mesh)
{
    const std::size_t before = impl_->files.size();
    try {
        // Writers use indices without a check.
        if (const std::string fault = check(mesh); !fault.empty()) fail(path, "it cannot be written: " + fault);
        const Writer writer = writer_for(path);
        if (extension_of(path) == "obj" && needs_mtl(mesh)) {
            // The materials first: the OBJ file that names them appears last.
            if (!can_name_mtl(path))
                fail(path,
                     "an OBJ file cannot name its material file like this; leave out line ends, control "
                     "characters and a blank at the beginning, or choose another format");
            OutputFile& materials = impl_->open(mtl_path(path));
            write_mtl(materials, mesh);
            materials.finish();
            write_obj(impl_->open(path), mesh, mtl_path(path).filename().string());
        } else {
            writer(impl_->open(path), mesh);
        }
        impl_->files.back().finish();
    } catch (const std::bad_alloc&) {
        impl_->keep(before);
        fail_without_memory(path, "write it; free some");
    } catch (...) {
        impl_->keep(before);
        throw;
    }
}

void MeshFileSet::add(const fs::path& path, std::string_view bytes)
{
    const std::size_t before = impl_->files.size();
    try {
        OutputFile& file = impl_->open(path);
        file.write(bytes);
        file.finish();
    } catch (const std::bad_alloc&) {
        impl_->keep(before);
        fail_without_memory(path, "write it; free some");
    } catch (...) {
        impl_->keep(before);
        throw;
    }
}

void MeshFileSet::protect(const std::vector<fs::path>& inputs)
{
    for (const OutputFile& file : impl_->files) refuse_to_replace(file.path(), inputs);
    impl_->inputs.insert(impl_->inputs.end(), inputs.begin(), inputs.end());
}

void MeshFileSet::commit()
{
    std::vector<OutputFile>& files = impl_->files;
    const SignalsWait signals_wait;
    std::size_t done = 0;
    try {
        for (; done < files.size(); ++done) files[done].commit();
    } catch (...) {
        for (std::size_t i = 0; i < done; ++i) files[i].withdraw();
        throw;
    }
    impl_->keep(0);
}

void write_mesh(const fs::path& path, const IndexedMesh& mesh)
{
    MeshFileSet files;
    files.add(path, mesh);
    files.commit();
}

}  // namespace kerf::core::io
