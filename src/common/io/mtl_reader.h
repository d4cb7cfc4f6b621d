#pragma once

#include <filesystem>
#include <string>
#include <unordered_map>

#include "common/indexed_mesh.h"

namespace kerf::io {

/// Adds the materials of an .mtl file: name, Kd, d or Tr, map_Kd. Materials are decoration, so a file that is not
/// there, and a line that makes no sense, change nothing.
void read_mtl(const std::filesystem::path& path, std::unordered_map<std::string, Material>& materials);

}  // namespace kerf::io
