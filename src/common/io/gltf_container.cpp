#include "common/io/gltf_container.h"

#include <algorithm>
#include <cstdint>
#include <string>

#include "common/io/bytes.h"
#include "common/io/read_formats.h"

namespace kerf::core::io {

namespace {

constexpr std::string_view kMagic = "glTF";
constexpr std::size_t kContainerHeader = 12, kChunkHeader = 8;
constexpr std::string_view kJsonChunk = "JSON";
constexpr std::string_view kBinaryChunk{"BIN\0", 4};

}  // namespace

GltfParts split_gltf(const std::filesystem::path& path, std::string_view bytes, ReadingNotes& notes)
{
    constexpr const char* kAgain = "; export it again";
    if (!bytes.starts_with(kMagic)) return {bytes, {}, false};
    if (bytes.size() < kContainerHeader + kChunkHeader) fail(path, std::string("it is truncated") + kAgain);
    const auto number = [&](std::size_t at) { return load<std::uint32_t>(bytes.data() + at, Endian::little); };
    if (number(4) != 2)
        fail(path, "it is GLB version " + std::to_string(number(4)) + ", not 2; export it again as glTF 2.0");
    const auto fail_as_truncated = [&] {
        fail(path, "it is truncated: it should have " + std::to_string(number(8)) + " bytes, but has " +
                       std::to_string(bytes.size()) + kAgain);
    };
    const std::size_t end = bytes.size();
    const auto name_at = [&](std::size_t at) {
        return at + kChunkHeader <= end ? bytes.substr(at + 4, 4) : std::string_view();
    };
    GltfParts parts;
    parts.is_container = true;
    std::size_t end_of_chunks = kContainerHeader;
    for (std::size_t at = kContainerHeader; at + kChunkHeader <= end;) {
        const std::size_t size = number(at), first = at + kChunkHeader;
        const std::string_view name = name_at(at);
        if (at == kContainerHeader && name != kJsonChunk)
            fail(path, std::string("its first chunk is not JSON") + kAgain);
        // Beyond the length that the header gives there may be anything.
        const bool is_ours = name == kJsonChunk || name == kBinaryChunk || at < number(8);
        if (size > end - first) {
            if (!is_ours) break;
            if (number(8) > end) fail_as_truncated();
            fail(path, std::string("it is truncated: a chunk is longer than the file") + kAgain);
        }
        if (name == kJsonChunk && parts.json.empty()) parts.json = bytes.substr(first, size);
        if (name == kBinaryChunk && parts.binary.empty()) parts.binary = bytes.substr(first, size);
        const bool is_behind = first + size > number(8);
        if (name == kJsonChunk || name == kBinaryChunk)
            notes.add("chunks that pass the end that the header gives read", is_behind ? 1 : 0);
        else
            notes.add(kBytesBehind, is_behind ? kChunkHeader + size : 0);
        const std::size_t behind = first + size, padded = first + (size + 3) / 4 * 4;
        const bool is_unpadded = behind != padded && name_at(behind) == kBinaryChunk;
        if (behind != padded && behind != end) notes.add("chunks whose length is no multiple of four");
        at = is_unpadded ? behind : padded;
        end_of_chunks = std::min(at, end);
    }
    // Chunks give their own lengths, but only a file with a binary chunk is sure to have all of them.
    const bool is_too_long = number(8) > end;
    if (is_too_long && (end_of_chunks != end || parts.binary.empty())) fail_as_truncated();
    notes.add("a length in the header that is larger than the file, whose chunks are whole", is_too_long ? 1 : 0);
    notes.add(kBytesBehind, end - end_of_chunks);
    return parts;
}

}  // namespace kerf::core::io
