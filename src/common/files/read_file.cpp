#include "common/files/read_file.h"

#include <fstream>
#include <system_error>
#include <utility>

namespace kerf::core::io {

namespace fs = std::filesystem;

namespace {

thread_local std::vector<fs::path>* files_read = nullptr;

}  // namespace

ReadRecord::ReadRecord(std::vector<fs::path>& files) : outer_(std::exchange(files_read, &files)) {}

ReadRecord::~ReadRecord()
{
    files_read = outer_;
}

std::string read_bytes(const fs::path& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    // The system would take the name to end there.
    const bool has_zero = path.native().find('\0') != fs::path::string_type::npos;
    if (has_zero || status.type() == fs::file_type::not_found)
        fail(path, "there is no such file; look at its name and folder");
    if (error) fail(path, "it cannot be read (" + error.message() + "); look at its name and folder");
    // A device or a pipe has no size to check a claim against, and may never end.
    if (status.type() != fs::file_type::regular) fail(path, "it is not a regular file; name one that is");
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) fail(path, "it cannot be read (" + error.message() + ")");

    std::ifstream file(path, std::ios::binary);
    if (!file) fail(path, "it cannot be opened for reading; allow that first");
    std::string bytes(static_cast<std::size_t>(size), '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (file.bad() || static_cast<std::uintmax_t>(file.gcount()) != size)
        fail(path, "it cannot be read to its end; copy it again");
    if (files_read != nullptr) files_read->push_back(path);
    return bytes;
}

}  // namespace kerf::core::io
