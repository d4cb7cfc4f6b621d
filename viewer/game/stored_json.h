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
    bool is_free = true;   ///< false: something stands there that could be neither read nor kept aside
};

/// Gives a reason why a value is not what it should be; empty: it is.
using Objection = std::function<std::string(const nlohmann::json&)>;

/// Larger files are no scores and no settings, bytes.
inline constexpr std::uintmax_t kMostStoredBytes = std::uintmax_t(16) << 20;

/// Reads a file that save_json() wrote. One that is damaged, or that `objection` objects to, is not lost: it is renamed
/// to NAME.damaged-1, -2, ... and a message says so. One of Kerf's whose `version` is beyond `newest` stays as it is:
/// a later version of the program will want it.
StoredJson load_json(const std::filesystem::path& path, const Objection& objection,
                     int newest = std::numeric_limits<int>::max());

/// Writes a file so that whatever happens, a kill or a power cut included, it holds either what it held or the whole of
/// `value`: under another name, synchronised with the disk, renamed. Creates the folder. One sentence when that failed;
/// then the file holds what it held. An interrupted call leaves NAME.new, which the next one replaces.
std::string save_json(const std::filesystem::path& path, const nlohmann::json& value);

/// Asked again and again while something is waited for: true ends the waiting.
using GivesUp = std::function<bool()>;

/// While it lives, no other process holds a FileLock on the same file: for reading, changing and writing in one go.
class FileLock
{
public:
    /// Waits until it has the lock or `gives_up`; without that, as long as it takes. Where the folder can't be created
    /// or locked, everything goes on without a lock.
    explicit FileLock(const std::filesystem::path& path, const GivesUp& gives_up = {});
    ~FileLock();
    FileLock(const FileLock&) = delete;
    FileLock& operator=(const FileLock&) = delete;

    /// Another process held it until this one gave up.
    bool is_held_elsewhere() const { return is_held_elsewhere_; }

private:
    int descriptor_ = -1;
    bool is_held_elsewhere_ = false;
};

}  // namespace kerf::game
