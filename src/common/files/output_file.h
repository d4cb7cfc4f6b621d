#pragma once

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "common/files/byte_sink.h"
#include "common/files/file_error.h"
#include "common/files/unfinished_files.h"

// A written file appears complete or not at all.

namespace kerf::core::io {

/// The file that a name stands for: where symbolic links lead, existing or not; without links the name itself.
/// @throws FileError  they lead in a circle
std::filesystem::path behind_links(const std::filesystem::path& path);

/// The same path for every name of one place (relative, another spelling, a link): its folder without links, and the
/// name there. Neither need exist.
/// @throws FileError  links lead in a circle
std::filesystem::path place_of(const std::filesystem::path& path);

/// A file that appears complete or not at all: it is written under a temporary name beside its place, and renamed. A
/// symbolic link of its name stays; the file that it leads to is replaced, or made.
///
/// It is written, finished and committed, once each and in this order. A call out of order throws FileError and changes
/// nothing: writing a finished file, committing an unfinished one, any call after a failure of write() or finish(), and
/// any call on a file that was moved from. So a file that is not complete never gets its name.
class OutputFile final : public ByteSink
{
public:
    /// @throws FileError  the folder cannot be written to, or something that is not a regular file has the name
    explicit OutputFile(std::filesystem::path path);
    ~OutputFile() override;  ///< removes the temporary file
    /// Leaves the other one without a file and without a path.
    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;

    const std::filesystem::path& path() const override { return path_; }
    /// The place where it appears: behind the links of its name.
    const std::filesystem::path& place() const { return place_; }

    /// Appends bytes. @throws FileError  for example: the disk is full; it is finished
    void write(std::string_view bytes) override;

    /// Waits until the disk holds what was written so far, so that not even a power cut after commit() loses any of it.
    /// Takes milliseconds. @throws FileError  for example: the disk is full; it is finished
    void synchronise();

    /// Hands everything to the system and closes. @throws FileError  for example: the disk is full; it is finished
    void finish();

    /// Gives the finished file its name; may be tried again. @throws FileError  for example: a folder has the name by
    /// now; it is not finished
    void commit();

    /// If commit() of this object has named it, gives the name back to the file that had it before, or to none;
    /// otherwise, and the second time, does nothing. File systems without hard links keep no file that is replaced.
    void withdraw() noexcept;

private:
    enum class State
    {
        open,
        finished,
        failed,  ///< bytes are missing
        named,
        gone,  ///< withdrawn or moved away
    };

    struct Close
    {
        void operator()(std::FILE* file) const { std::fclose(file); }
    };

    bool has_temporary() const noexcept;
    /// Gives the file that has the name, if there is one, a second, hidden name.
    void keep_previous();
    /// @throws FileError  it is in another state
    void expect(State state) const;
    /// For a reason as errno gives it.
    [[noreturn]] void fail_to_write(int reason) const;

    std::filesystem::path path_;
    std::filesystem::path place_;  ///< behind links
    std::filesystem::path temporary_;
    std::filesystem::path previous_;  ///< the file that had the name before, until this object ends; empty: nothing
    UnfinishedFile unfinished_, previous_unfinished_;
    std::unique_ptr<std::FILE, Close> file_;  ///< while it is open; after a failure perhaps
    State state_ = State::open;
};

}  // namespace kerf::core::io
