#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "common/assemble.h"
#include "common/mesh_facts.h"

namespace kerf::io {

/// A file that cannot be read or written. what() is one sentence that names the file and the reason.
class FileError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// A mesh file as it is: triangles (n-gons triangulated), several meshes and materials joined, node transforms applied.
/// OBJ, PLY, STL, OFF, glTF and GLB, by file name extension in either case. Text numbers are read correctly rounded.
/// Vertices are counted as the format stores them (OBJ: different v/vt/vn triples).
/// @throws FileError  unreadable, empty or malformed file; index out of range; a coordinate that is not finite
TriangleSoup read_soup(const std::filesystem::path& path);

/// A file made ready for cutting, with what was found and what was repaired.
struct LoadedMesh
{
    IndexedMesh mesh;
    MeshFacts facts;  ///< before repair
    Repairs repairs;
};

/// read_soup(), measure() and assemble() in one.
/// @throws FileError
LoadedMesh read_mesh(const std::filesystem::path& path);

/// Writes OBJ, PLY, STL or GLB, by extension. What is written as OBJ or PLY reads back bit for bit (positions, normals,
/// uv, and streams in PLY; points by equal positions). OBJ and GLB keep materials; OBJ has the groups `surface` and
/// `cap`. The file appears complete or not at all: it is written beside its place and renamed.
/// @throws FileError
void write_mesh(const std::filesystem::path& path, const IndexedMesh& mesh);

}  // namespace kerf::io
