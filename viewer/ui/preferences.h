#pragma once

#include <string>

namespace kerf::ui {

/// What a player chooses once and keeps.
struct Preferences
{
    std::string backend;  ///< empty: the default
    double volume = 0.8;  ///< 0 to 1
    bool muted = false;
    bool fullscreen = false;
    bool vsync = true;
    double window_scale = 1.0;  ///< of 1280x720

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

inline constexpr double kSmallestWindow = 0.5, kLargestWindow = 3.0;

}  // namespace kerf::ui
