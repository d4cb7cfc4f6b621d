#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "common/files/file_error.h"
#include "common/io/reading_notes.h"
#include "common/repair/repair.h"

// Reading and writing mesh files: what users of the library call.

namespace kerf::core::io {

/// Reads a mesh file without repair: triangles (n-gons triangulated without a new vertex), several meshes and materials
/// joined, node transforms applied. OBJ, PLY, STL, OFF, glTF and GLB, by file name extension in either case.
///
/// * Text numbers are read correctly rounded. -0 becomes +0 in coordinates.
/// * Vertices are counted as the format stores them (OBJ: different v/vt/vn triples that a face uses).
/// * uv have their origin in the lower left corner of the image, as in OBJ and OpenGL; glTF is converted.
/// * Normals farther than 1e-6 from unit length are normalised. If only some vertices have one, the others get the mean
///   of their triangles' normals, weighted by area. If a file gives none, and for STL, `has_normals` is false.
/// * Of glTF, what the scene shows, with EXT_mesh_gpu_instancing, KHR_mesh_quantization and KHR_texture_transform; no
///   Draco, no skins, no morph targets.
/// * Vertex colours are the stream "color" (3 or 4 floats, 0 to 1); other numbers of PLY vertices have streams as well.
///
/// A fault that does not matter for the surface never refuses a file: it is put right or passed over, and noted. So are
/// other programs' spellings that have one meaning; docs/files.md lists them. Text may be UTF-8, with or
/// without a byte order mark; except for the JSON of glTF it may also be UTF-16, told by its mark or by its first two
/// letters.
///
/// Time and memory are O(file size), whatever counts the file claims.
/// @param notes  receives what the reader was lenient about, if given
/// @throws FileError  unreadable, empty, truncated or malformed file; no triangles; a vertex index out of range; a face
///                    with a coordinate that is not finite
TriangleSoup read_soup(const std::filesystem::path& path, ReadingNotes* notes = nullptr);

/// The same of a file that is in memory. `format` is an extension, in lower case and without the dot. A file in memory
/// has no others beside it: of an OBJ file's materials only the names are kept, and buffers of glTF must be inside.
/// @throws FileError  as above; a format that is not read
TriangleSoup read_soup(std::string_view bytes, std::string_view format, ReadingNotes* notes = nullptr);

/// A file made ready for cutting, with its facts and repairs.
struct LoadedMesh
{
    ProvenMesh mesh;
    std::vector<std::filesystem::path> files;  ///< all that were read: the mesh, its material libraries and buffers
    MeshFacts facts;                           ///< before repair: Repaired::facts
    Repairs repairs;
    ReadingNotes notes;  ///< what the reader was lenient about

    /// Whether the repaired mesh has no boundary: it is the surface of solids, whose back one never sees. O(1).
    bool is_closed() const { return facts.closed(); }
};

/// read_soup() and repair() in one.
/// @throws FileError
LoadedMesh read_mesh(const std::filesystem::path& path);

/// The same of a file in memory; `files` stays empty.
/// @throws FileError
LoadedMesh read_mesh(std::string_view bytes, std::string_view format);

/// Writes OBJ, PLY, STL, OFF or GLB, by extension. OBJ and PLY read back bit for bit: positions, uv, normals of length
/// 1, and in PLY finite values of streams that have a name without blanks; points by equal positions. OFF holds the
/// positions of points, and triangles, and those read back bit for bit, too. OBJ and GLB keep
/// materials, OBJ in an .mtl file beside it if they say more than a name; OBJ has the groups `surface` and `cap`. The
/// file appears complete or not at all: it is written beside its place and renamed. If the name is a symbolic link, the
/// file that it leads to is replaced. Any mesh that check() accepts is written, proven or not.
/// @throws FileError
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh);

/// The bytes that write_mesh() writes. OBJ without its material file: of materials only the names are kept.
/// @throws FileError  a format that is not written; a mesh that check() refuses
std::string mesh_bytes(const IndexedMesh& mesh, std::string_view format);

/// Several mesh files that appear together or not at all, even if the program is interrupted
/// (common/files/unfinished_files.h).
class MeshFileSet
{
public:
    /// @param inputs  files that must not be replaced: LoadedMesh::files of a mesh written in parts
    explicit MeshFileSet(std::vector<std::filesystem::path> inputs = {});
    ~MeshFileSet();  ///< removes what was not committed
    MeshFileSet(const MeshFileSet&) = delete;
    MeshFileSet& operator=(const MeshFileSet&) = delete;

    /// Writes a mesh as write_mesh() does, under a temporary name beside its place. Refuses to replace an input, and to
    /// write two files to one place.
    /// @throws FileError
    void add(const std::filesystem::path& path, const IndexedMesh& mesh);
    /// The same of bytes as they are.
    /// @throws FileError
    void add(const std::filesystem::path& path, std::string_view bytes);

    /// More files that must not be replaced, with all of the set unchanged if a file of it would.
    /// @throws FileError
    void protect(const std::vector<std::filesystem::path>& inputs);

    /// Gives all files their names. If one cannot have its name, the ones renamed before are removed again.
    /// @throws FileError
    void commit();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Extensions that write_mesh() knows, in lower case and without the dot.
const std::vector<std::string>& writable_formats();

}  // namespace kerf::core::io
