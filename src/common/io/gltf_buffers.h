#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "common/io/reading_notes.h"

namespace kerf::core::io {

/// Whether a reference holds its data itself. Schemes are the same in either case.
bool is_data_uri(std::string_view uri);

/// "%20" is a space, and so on; nothing if a % begins no byte.
std::optional<std::string> percent_decoded(std::string_view text);

/// The bytes that the buffers of a glTF file name: base64 inside the file, or files beside it.
///
/// A buffer may only lie in the folder of the glTF file or below it: no absolute path, no "..", no other kind of
/// address. A file from elsewhere must not make us read files that its sender cannot. Backslashes are taken as slashes.
class GltfBuffers
{
public:
    GltfBuffers(const std::filesystem::path& path, ReadingNotes& notes) : path_(path), notes_(notes) {}

    /// @param uri    as the file has it: "data:...;base64,...", both words in either case, or a relative path;
    /// percent-encoded
    /// @param where  names the buffer in messages: "buffer 0"
    /// @throws FileError
    std::string_view bytes_of(const std::string& uri, const std::string& where);

    /// Bytes in files of their own, each counted once.
    std::uint64_t bytes_beside() const { return beside_; }

private:
    std::string decode(std::string_view uri, const std::string& where);
    std::string read_beside(std::string_view uri, const std::string& where);

    const std::filesystem::path& path_;
    ReadingNotes& notes_;
    std::map<std::string, std::string, std::less<>> bytes_;  ///< by uri: however often it is named, it is held once
    std::uint64_t beside_ = 0;
};

}  // namespace kerf::core::io
