#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "common/files/file_error.h"
#include "common/io/reading_notes.h"
#include "common/mesh/triangle_soup.h"

// One reader per format. Each gets the whole file as bytes and returns its triangles; SoupBuilder checks and completes
// what all formats have in common. Harmless faults are put right and noted. All throw FileError.

namespace kerf::core::io {

/// The file of this name in the folder of `path` or below it; nothing for an absolute path, one with "..", one of
/// another system or an address. A file from elsewhere must not make us read files that its sender cannot.
std::optional<std::filesystem::path> file_beside(const std::filesystem::path& path, const std::string& name);

TriangleSoup read_obj(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes);
TriangleSoup read_off(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes);
TriangleSoup read_ply(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes);
TriangleSoup read_stl(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes);

/// glTF text with its buffers beside it, or GLB.
TriangleSoup read_gltf(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes);

}  // namespace kerf::core::io
