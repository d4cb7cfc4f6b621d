#pragma once

#include <chrono>
#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "viewer/game/high_scores.h"
#include "viewer/game/stored_settings.h"

namespace kerf::game {

/// Scores and settings as a game sees them: known at once, written by a thread of its own. No call waits for the disk
/// or for another program that holds a file; the destructor does, for a second at most.
class UserFiles
{
public:
    /// How long the end of the program waits for another program that holds a file.
    static constexpr std::chrono::milliseconds kPatience{1000};

    /// Reads the scores. @param folder  user_folder(); empty: nothing is stored
    explicit UserFiles(const std::filesystem::path& folder);
    /// Writes what waits.
    ~UserFiles();
    UserFiles(const UserFiles&) = delete;
    UserFiles& operator=(const UserFiles&) = delete;

    std::span<const HighScore> scores_of(GameMode mode) const { return known_.of(mode); }
    std::int64_t best(GameMode mode) const { return known_.best(mode); }

    /// Puts a game into the list and has it stored. Its place among those that this program knows; empty: none.
    std::optional<std::size_t> add(GameMode mode, const HighScore& score);
    /// Has settings stored; of several that wait only the last.
    void store(const StoredSettings& settings);

    /// What went wrong since the last call; empty: nothing. One sentence.
    std::string take_message();

private:
    void write_all();
    bool gives_up();

    std::filesystem::path folder_;
    HighScores known_;

    std::mutex mutex_;  ///< of all that follows
    std::condition_variable wakes_;
    std::deque<std::pair<GameMode, HighScore>> scores_;
    std::optional<StoredSettings> settings_;
    std::string message_;
    std::optional<std::chrono::steady_clock::time_point> deadline_;  ///< set when the program ends
    std::thread writer_;
};

}  // namespace kerf::game
