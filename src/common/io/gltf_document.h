#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace kerf::io {

/// What Assimp is to read instead of a glTF or GLB file.
struct CheckedGltf
{
    std::string document;         ///< in the form of the file: text, or GLB
    std::uint64_t triangles = 0;  ///< of all meshes, each once
};

/// Checks a glTF or GLB file before Assimp reads it.
///
/// Assimp 5.2 believes what a file says about its own sizes: a chunk length of 4 GB is allocated, a strip of one index
/// is minus one triangles long, a node that is its own child recurses for ever, and integers where floats belong are
/// taken for floats; and triangles whose index is out of range are
/// dropped in silence. So: every length is held against the bytes that are there, every reference against the list it
/// points into, component types against what Assimp converts, and the nodes must be trees. Parts that say nothing about
/// the surface at rest (animations, skins, morph targets, cameras, lights) are left out; and triangles are counted.
///
/// O(file size) plus the size of the buffers beside it.
/// @throws FileError
CheckedGltf checked_gltf(const std::filesystem::path& path, std::string_view bytes);

}  // namespace kerf::io
