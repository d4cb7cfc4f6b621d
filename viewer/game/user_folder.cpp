#include "viewer/game/user_folder.h"

#include <cstdlib>

namespace kerf::game {
namespace {

std::filesystem::path absolute_path_in(const char* variable)
{
    const char* const text = std::getenv(variable);
    const std::filesystem::path path = text == nullptr ? "" : text;
    return path.is_absolute() ? path : std::filesystem::path();
}

}  // namespace

std::filesystem::path user_folder()
{
    if (const std::filesystem::path data = absolute_path_in("XDG_DATA_HOME"); !data.empty()) return data / "kerf";
    if (const std::filesystem::path home = absolute_path_in("HOME"); !home.empty())
        return home / ".local" / "share" / "kerf";
    return {};
}

}  // namespace kerf::game
