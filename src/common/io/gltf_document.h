#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "common/io/gltf_buffers.h"

namespace kerf::io {

using GltfJson = nlohmann::json;

/// Component types, by the format's numbers.
enum class GltfComponent : std::uint64_t
{
    int8 = 5120,
    uint8 = 5121,
    int16 = 5122,
    uint16 = 5123,
    uint32 = 5125,
    float32 = 5126
};

/// Modes of primitives that are triangles; smaller numbers are points and lines.
inline constexpr std::uint64_t kGltfTriangles = 4, kGltfStrip = 5, kGltfFan = 6;

/// `count` elements of `width` numbers, all of them inside their buffer.
struct GltfAccessor
{
    const char* first = nullptr;
    std::uint64_t count = 0, stride = 0, width = 0;
    GltfComponent component = GltfComponent::float32;
};

/// A glTF document in which nothing points beside itself.
struct GltfDocument
{
    GltfJson json;
    GltfBuffers buffers;                  ///< own the bytes that are not in the file
    std::vector<GltfAccessor> accessors;  ///< by index
};

/// Checks a glTF or GLB file: every length is held against the bytes that are there, every reference against the list
/// that it points into, types of numbers against what the format allows, and the nodes must be trees that don't repeat
/// meshes without measure. A reader that follows the references needs no check of its own but for vertex indices.
///
/// `bytes` must outlive the result. O(file size) plus the size of the buffers beside it.
/// @throws FileError
GltfDocument check_gltf(const std::filesystem::path& path, std::string_view bytes);

}  // namespace kerf::io
