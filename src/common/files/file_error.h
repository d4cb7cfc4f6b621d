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

/// The same, because memory ran out.
class NoMemoryForFile : public FileError
{
public:
    using FileError::FileError;
};

/// @throws FileError  "FILE: REASON"
[[noreturn]] void fail(const std::filesystem::path& path, const std::string& reason);
/// @throws NoMemoryForFile  "FILE: there is not enough memory to DO; REMEDY"
[[noreturn]] void fail_without_memory(const std::filesystem::path& path, const std::string& to_do_and_remedy);

}  // namespace kerf::core::io
