#pragma once

#include <filesystem>
#include <string_view>

#include "common/io/reading_notes.h"

namespace kerf::core::io {

/// The chunks of a GLB file, or the text of a glTF file.
struct GltfParts
{
    std::string_view json;
    std::string_view binary;
    bool is_container = false;
};

/// Splits a GLB file; every length is checked against the bytes that are there. Views into `bytes`. O(chunks).
///
/// Chunks begin at multiples of four. If a length is no multiple, some programs pad it and others do not: the next
/// chunk begins where its name stands.
/// @throws FileError  another version; the file, or one of its first two kinds of chunks, is shorter than it says
GltfParts split_gltf(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes);

}  // namespace kerf::core::io
