#pragma once

#include <filesystem>

namespace kerf::game {

/// Where a user's scores and settings live: $XDG_DATA_HOME/kerf, or $HOME/.local/share/kerf (XDG Base Directory
/// Specification 0.8; a relative XDG_DATA_HOME does not count). Empty when neither is known. Does not create it.
std::filesystem::path user_folder();

}  // namespace kerf::game
