#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "viewer/game/stored_json.h"

namespace kerf::game {

/// What the program remembers from one start to the next.
struct StoredSettings
{
    double volume = 0.7;  ///< 0 to 1
    bool mute = false;
    std::string backend;  ///< empty: the default
    std::string scene;    ///< played last; empty: none yet
    bool fullscreen = false;
    double window_scale = 1.0;  ///< of 1280x720, 0.5 to 3
    bool vsync = true;
    std::int64_t giant = 100'000;  ///< triangles, kFewestGiantTriangles to kMostGiantTriangles

    friend bool operator==(const StoredSettings&, const StoredSettings&) = default;
};

/// Settings that were stored, and what was wrong with them (one sentence; empty: nothing).
struct LoadedSettings
{
    StoredSettings settings;
    std::string message;
};

/// Reads `settings.json` of a folder; format: docs/game.md. What is missing, of the wrong type or out of range is as
/// the default says: a setting is no reason not to start. A file that is no JSON is set aside, as load_json() does.
/// @param folder  user_folder(); empty: the defaults
LoadedSettings load_settings(const std::filesystem::path& folder);

/// Stores them, as save_json() does; keys that this version does not know stay. One sentence when that failed.
std::string save_settings(const std::filesystem::path& folder, const StoredSettings& settings);

}  // namespace kerf::game
