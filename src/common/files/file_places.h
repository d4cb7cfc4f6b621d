#pragma once

#include <filesystem>
#include <span>

#include "common/files/file_error.h"

// What is written must not replace what is read, nor anything else that is written.

namespace kerf::core::io {

/// @throws FileError  `output` is one of `inputs`, by whatever name: another spelling, a symbolic or a hard link
void refuse_to_replace(const std::filesystem::path& output, std::span<const std::filesystem::path> inputs);

/// @throws FileError  `output` is written to the place of one of `others`
void refuse_same_place(const std::filesystem::path& output, std::span<const std::filesystem::path> others);

/// What refuse_same_place() throws.
[[noreturn]] void fail_for_same_place(const std::filesystem::path& output);

}  // namespace kerf::core::io
