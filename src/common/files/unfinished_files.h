#pragma once

#include <csignal>
#include <filesystem>
#include <memory>

// Temporary files are removed if a signal ends the program.

namespace kerf::core::io {

/// The record of a temporary file for a signal handler.
struct UnfinishedPlace;
struct ForgetUnfinished
{
    void operator()(UnfinishedPlace* place) const noexcept;
};

/// While this lives, remove_unfinished_files() removes a temporary file. Only memory limits their number.
using UnfinishedFile = std::unique_ptr<UnfinishedPlace, ForgetUnfinished>;

/// Call it before the file is made, with a name that is nobody else's, so that the file is always recorded. O(1).
/// @throws std::bad_alloc
[[nodiscard]] UnfinishedFile remember_unfinished(const std::filesystem::path& path);

/// Removes the temporary files of all output that is being written. Async-signal-safe. O(files that were ever
/// unfinished at one time).
void remove_unfinished_files() noexcept;

/// For programs: signals that end them, such as SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGALRM and SIGXCPU, remove
/// unfinished files first, and then end the program as if they had not been caught. One that is ignored (nohup) or
/// caught already stays so, but for SIGINT and SIGTERM. SIGXFSZ is ignored: writing beyond the limit of a file's size
/// fails as on a full disk.
void remove_unfinished_files_on_signals() noexcept;

/// While this lives, the signals of remove_unfinished_files_on_signals() wait if they come to this thread: files that
/// get their names in several steps get all or none.
class SignalsWait
{
public:
    SignalsWait() noexcept;
    ~SignalsWait();
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;

private:
    sigset_t before_;
};

}  // namespace kerf::core::io
