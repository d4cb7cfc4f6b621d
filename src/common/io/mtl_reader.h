#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <unordered_map>

#include "common/mesh/indexed_mesh.h"

namespace kerf::core::io {

using MaterialLibrary = std::unordered_map<std::string, Material>;

/// Adds the materials of an .mtl file: name, Kd, d or Tr, map_Kd. Materials are decoration, so a file that is not
/// there, and a line that makes no sense, change nothing.
void read_mtl(const std::filesystem::path& path, MaterialLibrary& materials);

/// The same from the bytes of the file.
void parse_mtl(const std::filesystem::path& path, std::string_view bytes, MaterialLibrary& materials);

}  // namespace kerf::core::io
