#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "common/io/unfinished_files.h"

namespace kerf::io {

/// The file that a name stands for: where symbolic links lead, whether there is something or not; otherwise the name.
/// @throws FileError  they lead in a circle
std::filesystem::path behind_links(const std::filesystem::path& path);

/// The same for every name of one place, be it relative, another spelling or a link: its folder without links, and the
/// name there. Neither need exist.
/// @throws FileError  links lead in a circle
std::filesystem::path place_of(const std::filesystem::path& path);

/// A file that appears complete or not at all: it is written under a temporary name beside its place, and renamed. A
/// symbolic link of its name stays; what it leads to is replaced, or made.
class OutputFile
{
public:
    /// @throws FileError  the folder cannot be written to, or something that is not a regular file has the name
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile();  ///< removes the temporary file
    OutputFile(OutputFile&&) noexcept = default;
    OutputFile& operator=(OutputFile&&) = delete;

    const std::filesystem::path& path() const { return path_; }
    /// Where it appears: behind the links of its name.
    const std::filesystem::path& place() const { return place_; }

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

    /// For a reason as errno gives it.
    [[noreturn]] void fail_to_write(int reason) const;

    std::filesystem::path path_;
    std::filesystem::path place_;      ///< behind links
    std::filesystem::path temporary_;  ///< empty: committed, or moved from
    UnfinishedFile unfinished_;
    std::unique_ptr<std::FILE, Close> file_;
};

}  // namespace kerf::io
