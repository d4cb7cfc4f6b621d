#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace kerf::core::io {

/// A file that cannot be read or written. what() is one sentence that names the file and the reason.
class FileError : public std::runtime_error
{
public:
    using std::runtime_error::runtime_error;
};

/// @throws FileError  "FILE: REASON"
[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason);

}  // namespace kerf::core::io
