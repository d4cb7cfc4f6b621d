#pragma once

#include <filesystem>

namespace kerf::app {

/// "kerf_000.png", "kerf_001.png", ... in a folder: the first that is not there yet. O(pictures that are there).
std::filesystem::path new_picture_name(const std::filesystem::path& folder = {});

}  // namespace kerf::app
