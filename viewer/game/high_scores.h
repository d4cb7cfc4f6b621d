#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "viewer/game/game_mode.h"
#include "viewer/game/game_state.h"
#include "viewer/game/stored_json.h"

namespace kerf::game {

/// A game that was worth keeping.
struct HighScore
{
    std::int64_t score = 0;
    std::string date;     ///< UTC: 2026-11-21T15:08:00Z
    std::string backend;  ///< that cut
    std::uint64_t seed = 0;
    std::int64_t fruit = 0;  ///< cut
    std::int64_t longest_combo = 0;

    friend bool operator==(const HighScore&, const HighScore&) = default;
};

/// Of a game that is over, dated now.
HighScore score_of(const GameState& state, const std::string& backend, std::uint64_t seed);

/// The best ten games of each mode, in the file `scores.json` of a folder; format: docs/game.md. Two programs may use
/// one folder: adding reads the file again first.
class HighScores
{
public:
    static constexpr std::size_t kKept = 10;

    /// Reads the file. @param folder  user_folder(); empty: nothing is stored
    explicit HighScores(const std::filesystem::path& folder);

    /// Best first; of equal scores the earlier game.
    std::span<const HighScore> of(GameMode mode) const;
    /// 0 when there is none.
    std::int64_t best(GameMode mode) const;

    /// Puts a game into the list and stores it. Its place from 0; empty when ten others are at least as good, or when
    /// there is nothing to be proud of (0 points). What cannot be stored stays in the list until the program ends.
    std::optional<std::size_t> add(GameMode mode, const HighScore& score);

    /// What went wrong with the file since the last call; empty: nothing. One sentence.
    std::string take_message() { return std::exchange(message_, {}); }

private:
    void read();
    std::optional<std::size_t> insert(GameMode mode, const HighScore& score);
    void write();

    std::filesystem::path path_;
    std::map<GameMode, std::vector<HighScore>> scores_;
    std::string message_;
    bool may_write_ = true;
};

}  // namespace kerf::game
