#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace kerf::io {

/// A file that appears complete or not at all: it is written under a temporary name beside its place, and renamed.
class OutputFile
{
public:
    /// @throws FileError  the folder cannot be written to, or something that is not a regular file has the name
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();  ///< removes the temporary file
    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;

    const std::filesystem::path& path() const { return path_; }

    /// Appends bytes. @throws FileError  for example: the disk is full
    void write(std::string_view bytes);

    /// Hands everything to the system and closes. @throws FileError
    void finish();

    /// Gives the finished file its name. @throws FileError
    void commit();

    /// Removes a file that commit() has named.
    void withdraw() noexcept;

private:
    struct Close
    {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    [[noreturn]] void fail_to_write() const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;  ///< empty: committed, or moved from
    int unfinished_ = -1;              ///< its number in unfinished_files.h
    std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace kerf::io
