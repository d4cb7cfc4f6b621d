#pragma once

#include <filesystem>

namespace kerf::io {

/// Remembers a temporary file until forget_unfinished() gets the number that this returns, so that
/// remove_unfinished_files() can find it; -1 when there is no room (then an interruption leaves the file behind).
int remember_unfinished(const std::filesystem::path& path) noexcept;
void forget_unfinished(int number) noexcept;

/// Removes the temporary files of all output that is being written. For the signal handlers of programs:
/// async-signal-safe.
void remove_unfinished_files() noexcept;

}  // namespace kerf::io
