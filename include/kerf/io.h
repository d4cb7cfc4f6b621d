#pragma once

#include <kerf/export.h>
#include <kerf/mesh.h>
#include <kerf/status.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace kerf {

/// @addtogroup files
/// Files to meshes, and meshes to files. Component `io`. docs/files.md says what is read and written, format by format.
///
/// If memory runs out, the status is `out_of_memory`; but glTF and GLB hold a JSON document, and the library that reads
/// it takes some memory to let go of one: if even that is not there, the program ends.
/// @{

/// What reading a file says besides the mesh.
class KERF_API FileReport
{
public:
    /// An empty one; what is moved from is empty, too.
    /// @{
    FileReport() noexcept = default;
    FileReport(FileReport&& other) noexcept;
    FileReport& operator=(FileReport&& other) noexcept;
    /// @}
    ~FileReport();

    /// Facts of the mesh as the file has it, and what was repaired.
    const MeshReport& mesh() const noexcept;

    /// Something in the file that says nothing about the surface and that was put right or passed over.
    struct Note
    {
        const char* what = "";    ///< a clause without the number: "normals that are not finite numbers made anew"
        std::uint64_t count = 0;  ///< how often
    };
    std::size_t note_count() const noexcept;  ///< of note()
    Note note(std::size_t i) const noexcept;  ///< an empty one if there is none of that number

    /// All files that were read: the mesh, its material libraries and buffers.
    std::size_t file_count() const noexcept;
    const char* file(std::size_t i) const noexcept;  ///< "" if there is none of that number

    /// @cond For the library itself.
    struct Data;
    const Data* data() const noexcept { return data_; }
    /// @endcond

private:
    friend struct FileReportMaker;
    Data* data_ = nullptr;
};

/// Reads a mesh file and repairs it, as Mesh::make() does: OBJ, PLY, STL, OFF, glTF and GLB, by the extension in either
/// case. O(n log n) in the file's size, whatever counts it claims. Status: `unusable_file` with a sentence that names
/// the file and the fault (also one of the mesh in it), `invalid_argument` for a null path, `out_of_memory`.
///
///     kerf::FileReport report;
///     const kerf::Result<kerf::Mesh> mesh = kerf::read_mesh(path, &report);
///     if (!mesh) return complain(mesh.reason());
///     const kerf::Sentence repairs = kerf::describe(report.mesh().repairs);
///     if (!repairs.is_empty()) std::printf("%s: %s\n", path, repairs.c_str());
///
/// @param path    UTF-8
/// @param report  receives facts, repairs, notes and files, and is empty if there is no mesh; may be null
KERF_API Result<Mesh> read_mesh(const char* path, FileReport* report = nullptr) noexcept;

/// The same of a file in memory. It has no other files beside it: of an OBJ file's materials only the names are kept,
/// and the buffers of glTF must be inside.
///
/// @param format  an extension without the dot: "obj", "ply", "stl", "off", "gltf", "glb"
KERF_API Result<Mesh> read_mesh(std::span<const std::byte> file, const char* format,
                                FileReport* report = nullptr) noexcept;

/// Writes OBJ, PLY, STL, OFF or GLB, by the extension. The file appears complete or not at all. Positions, normals, uv
/// and triangles of OBJ and PLY read back bit for bit, triangles sorted by solid and material if they were not; OBJ and
/// GLB keep materials, PLY keeps streams. What a format has no place for is left out without a word: materials in PLY,
/// STL and OFF, streams in all but PLY, normals and uv in STL and OFF (docs/files.md). O(n). Status: `unusable_file` (a
/// format that is not written, a folder that is not there, a full disk), `invalid_mesh` for an empty mesh,
/// `invalid_argument` for a null path, `out_of_memory`.
KERF_API Outcome write_mesh(const Mesh& mesh, const char* path) noexcept;

/// A file in memory.
class KERF_API FileBytes
{
public:
    /// An empty one; what is moved from is empty, too.
    /// @{
    FileBytes() noexcept = default;
    FileBytes(FileBytes&& other) noexcept;
    FileBytes& operator=(FileBytes&& other) noexcept;
    /// @}
    ~FileBytes();

    std::span<const std::byte> bytes() const noexcept;  ///< valid as long as this is

    /// @cond For the library itself.
    struct Data;
    explicit FileBytes(Data* data) noexcept : data_(data) {}
    /// @endcond

private:
    Data* data_ = nullptr;
};

/// The bytes that write_mesh() writes, with its statuses. OBJ without its material file: of materials only the names
/// are kept.
KERF_API Result<FileBytes> mesh_file_bytes(const Mesh& mesh, const char* format) noexcept;

/// A mesh in a scene.
struct SceneNode
{
    const char* name = "";       ///< UTF-8
    const Mesh* mesh = nullptr;  ///< one that is not empty
    Vec3d translation;           ///< where it is moved to, in its unit
    const char* extras = "";     ///< JSON, what else there is to say of it; "" for nothing
};

/// The bytes of a GLB file with a node for each mesh: the pieces of a fracture. Materials that are alike are written once.
/// O(n). Status: `unusable_file` (extras that are no JSON, more than 4 GB), `invalid_mesh` for an empty mesh,
/// `invalid_argument` for a null pointer, `out_of_memory`.
KERF_API Result<FileBytes> scene_file_bytes(std::span<const SceneNode> nodes) noexcept;

/// The extension of a format that read_mesh() knows, in lower case and without the dot; null beyond the last.
KERF_API const char* readable_format(std::size_t i) noexcept;
/// The extension of a format that write_mesh() knows, in lower case and without the dot; null beyond the last.
KERF_API const char* writable_format(std::size_t i) noexcept;

/// Several mesh files that appear together or not at all. What was not committed is removed at the end.
class KERF_API MeshFileSet
{
public:
    /// One that may replace any file.
    MeshFileSet() noexcept = default;
    /// @param inputs  whose files must not be replaced
    explicit MeshFileSet(const FileReport& inputs) noexcept;
    /// What is moved from holds no files.
    /// @{
    MeshFileSet(MeshFileSet&& other) noexcept;
    MeshFileSet& operator=(MeshFileSet&& other) noexcept;
    /// @}
    ~MeshFileSet();

    /// Writes a mesh as write_mesh() does, under a temporary name beside its place. Refuses to replace an input, and to
    /// write two files to one place. Status as write_mesh().
    Outcome add(const char* path, const Mesh& mesh) noexcept;
    /// The same of bytes as they are: a drawing (kerf/drawing.h), or a list of what belongs to the meshes.
    Outcome add(const char* path, std::span<const std::byte> bytes) noexcept;
    /// Files that must not be replaced, besides those before: for a set of what was read from several files. Refused,
    /// with the set unchanged, if a file that was added would replace one of them. Status: `unusable_file`,
    /// `out_of_memory`.
    /// @param inputs  whose files must not be replaced
    Outcome protect(const FileReport& inputs) noexcept;
    /// Gives all files their names. If one cannot have its name, none has, and the set is spent: add the files to
    /// another one. Status: `unusable_file`, `out_of_memory`.
    Outcome commit() noexcept;

private:
    struct Data;
    Data* data_ = nullptr;
    bool is_unprotected_ = false;  ///< there was no memory to remember what must not be replaced
};

/// For programs: signals that end them, such as SIGINT and SIGTERM, remove files that are being written first, and then
/// end the program as if they had not been caught. One that is ignored or caught already stays so, but for SIGINT and
/// SIGTERM.
KERF_API void remove_unfinished_files_on_signals() noexcept;

/// @}

}  // namespace kerf
