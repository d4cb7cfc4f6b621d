#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "common/files/file_error.h"

namespace kerf::core::io {

/// All bytes of a regular file. @throws FileError
std::string read_bytes(const std::filesystem::path& path);

/// While it lives, it records what read_bytes() reads in this thread: a mesh file names others, and only its reader
/// knows which.
class ReadRecord
{
public:
    explicit ReadRecord(std::vector<std::filesystem::path>& files);
    ~ReadRecord();
    ReadRecord(const ReadRecord&) = delete;
    ReadRecord& operator=(const ReadRecord&) = delete;

private:
    std::vector<std::filesystem::path>* outer_;
};

}  // namespace kerf::core::io
