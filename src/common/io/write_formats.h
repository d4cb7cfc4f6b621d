#pragma once

#include <filesystem>

#include <string>

#include "common/files/byte_sink.h"
#include "common/mesh/indexed_mesh.h"

// One writer per format. Each writes the whole file; the caller finishes and commits it. All throw FileError.

namespace kerf::core::io {

/// Positions and triangles alone: the plain form, which every program reads.
void write_off(ByteSink& file, const IndexedMesh& mesh);
/// @param materials  name of the file that has the materials; empty for none
void write_obj(ByteSink& file, const IndexedMesh& mesh, const std::string& materials);
void write_ply(ByteSink& file, const IndexedMesh& mesh);
void write_stl(ByteSink& file, const IndexedMesh& mesh);
void write_glb(ByteSink& file, const IndexedMesh& mesh);

/// The materials of an OBJ file have a file of their own if they say more than a name.
bool needs_mtl(const IndexedMesh& mesh);
std::filesystem::path mtl_path(const std::filesystem::path& obj_path);
/// Whether a line of the OBJ file can hold that file's name: there are no escapes.
bool can_name_mtl(const std::filesystem::path& obj_path);
void write_mtl(ByteSink& file, const IndexedMesh& mesh);

}  // namespace kerf::core::io
