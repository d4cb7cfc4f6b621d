#pragma once

#include <filesystem>

#include "common/io/output_file.h"
#include "common/mesh/indexed_mesh.h"

// One writer per format. Each writes the whole file; the caller finishes and commits it. All throw FileError.

namespace kerf::io {

void write_obj(OutputFile& file, const IndexedMesh& mesh);
void write_ply(OutputFile& file, const IndexedMesh& mesh);
void write_stl(OutputFile& file, const IndexedMesh& mesh);
void write_glb(OutputFile& file, const IndexedMesh& mesh);

/// The materials of an OBJ file have a file of their own if they say more than a name.
bool needs_mtl(const IndexedMesh& mesh);
std::filesystem::path mtl_path(const std::filesystem::path& obj_path);
/// Whether a line of the OBJ file can hold that file's name: there are no escapes.
bool can_name_mtl(const std::filesystem::path& obj_path);
void write_mtl(OutputFile& file, const IndexedMesh& mesh);

}  // namespace kerf::io
