#pragma once

#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>

namespace kerf::game {

/// What a stored file holds.
struct StoredJson
{
    nlohmann::json value;  ///< null: there is none, or it is damaged
    std::string message;   ///< one sentence when something is wrong, and what was done about it
    bool is_free = true;   ///< false: something stands there that could be neither read nor set aside
};

/// Gives a reason why a value is not what it should be; empty: it is.
using Objection = std::function<std::string(const nlohmann::json&)>;

/// Larger files are no scores and no settings, bytes.
inline constexpr std::uintmax_t kMostStoredBytes = std::uintmax_t(16) << 20;

/// Reads a file that save_json() wrote. One that is damaged or that `objection` refuses is renamed to NAME.damaged,
/// and a message says so. It stays where it is if there is such a file already: nothing is ever written over. One of
/// Kerf's whose `version` is beyond `newest` stays as well: a later version of the program will want it.
StoredJson load_json(const std::filesystem::path& path, const Objection& objection,
                     int newest = std::numeric_limits<int>::max());

/// Writes a file so that whatever happens, a kill or a power cut included, it holds either what it held or the whole of
/// `value` (core::io::OutputFile). Creates the folder. One sentence when that failed; then the file holds what it held.
std::string save_json(const std::filesystem::path& path, const nlohmann::json& value);

}  // namespace kerf::game
