#include "viewer/app/picture_name.h"

#include <array>
#include <cstdio>
#include <system_error>

namespace kerf::app {

std::filesystem::path new_picture_name(const std::filesystem::path& folder)
{
    std::error_code ignored;
    for (int number = 0;; ++number) {
        std::array<char, 32> name{};
        std::snprintf(name.data(), name.size(), "kerf_%03d.png", number);
        std::filesystem::path path = folder / name.data();
        if (!std::filesystem::exists(path, ignored)) return path;
    }
}

}  // namespace kerf::app
