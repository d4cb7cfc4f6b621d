#include "viewer/game/high_scores.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <limits>
#include <utility>

namespace kerf::game {
namespace {

constexpr const char* kScoresFormat = "kerf-scores";
constexpr int kVersion = 1;

std::string now_as_text()
{
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
    return text.data();
}

bool holds_text(const nlohmann::json& json, const char* key)
{
    return json.contains(key) && json[key].is_string();
}

bool holds_count(const nlohmann::json& json, const char* key)
{
    return json.contains(key) && json[key].is_number_unsigned() &&
           json[key].get<std::uint64_t>() <= std::uint64_t(std::numeric_limits<std::int64_t>::max());
}

bool is_score(const nlohmann::json& json)
{
    return json.is_object() && holds_count(json, "score") && holds_text(json, "date") && holds_text(json, "backend") &&
           json.contains("seed") && json["seed"].is_number_unsigned() && holds_count(json, "fruit") &&
           holds_count(json, "longest_combo");
}

std::string objection_to_scores(const nlohmann::json& json)
{
    if (!json.is_object() || json.value("format", nlohmann::json()) != kScoresFormat)
        return "it holds no scores of Kerf";
    if (json.value("version", nlohmann::json()) != kVersion) return "its version is not known";
    const nlohmann::json modes = json.value("modes", nlohmann::json());
    if (!modes.is_object()) return "it has no modes";
    for (const auto& [name, scores] : modes.items())
        if (!scores.is_array() || !std::all_of(scores.begin(), scores.end(), is_score))
            return "the scores of " + name + " are not readable";
    return {};
}

HighScore score_from(const nlohmann::json& json)
{
    HighScore score;
    json["score"].get_to(score.score);
    json["date"].get_to(score.date);
    json["backend"].get_to(score.backend);
    json["seed"].get_to(score.seed);
    json["fruit"].get_to(score.fruit);
    json["longest_combo"].get_to(score.longest_combo);
    return score;
}

nlohmann::json json_of(const HighScore& score)
{
    return {{"score", score.score}, {"date", score.date},   {"backend", score.backend},
            {"seed", score.seed},   {"fruit", score.fruit}, {"longest_combo", score.longest_combo}};
}

bool is_better(const HighScore& a, const HighScore& b)
{
    return a.score > b.score;
}

}  // namespace

HighScore score_of(const GameState& state, const std::string& backend, std::uint64_t seed)
{
    return {state.score, now_as_text(), backend, seed, state.counts.fruit_cut, state.counts.longest_combo};
}

HighScores::HighScores(const std::filesystem::path& folder)
    : path_(folder.empty() ? std::filesystem::path() : folder / "scores.json")
{
    read();
}

void HighScores::read()
{
    if (path_.empty()) return;
    StoredJson stored = load_json(path_, objection_to_scores, kVersion);
    may_write_ = stored.is_free;
    if (!stored.message.empty()) message_ = std::move(stored.message);
    if (stored.value.is_null()) return;
    const auto known = std::exchange(scores_, {});
    for (const GameMode mode : kGameModes) {
        const std::string name(name_of(mode));
        if (!stored.value["modes"].contains(name)) continue;
        std::vector<HighScore>& scores = scores_[mode];
        for (const nlohmann::json& json : stored.value["modes"][name]) scores.push_back(score_from(json));
        std::stable_sort(scores.begin(), scores.end(), is_better);
        if (scores.size() > kKept) scores.resize(kKept);
    }
    // What could not be stored is in no file.
    for (const auto& [mode, scores] : known)
        for (const HighScore& score : scores)
            if (const auto stored_now = of(mode);
                std::find(stored_now.begin(), stored_now.end(), score) == stored_now.end())
                insert(mode, score);
}

void HighScores::write()
{
    if (path_.empty() || !may_write_) return;
    nlohmann::json modes = nlohmann::json::object();
    for (const auto& [mode, scores] : scores_) {
        nlohmann::json list = nlohmann::json::array();
        for (const HighScore& score : scores) list.push_back(json_of(score));
        modes[std::string(name_of(mode))] = std::move(list);
    }
    std::string message =
        save_json(path_, {{"format", kScoresFormat}, {"version", kVersion}, {"modes", std::move(modes)}});
    if (!message.empty()) message_ = std::move(message);
}

std::span<const HighScore> HighScores::of(GameMode mode) const
{
    const auto found = scores_.find(mode);
    return found == scores_.end() ? std::span<const HighScore>() : found->second;
}

std::int64_t HighScores::best(GameMode mode) const
{
    const std::span<const HighScore> scores = of(mode);
    return scores.empty() ? 0 : scores.front().score;
}

std::optional<std::size_t> HighScores::add(GameMode mode, const HighScore& score)
{
    if (score.score <= 0) return std::nullopt;
    read();  // another program may have added to the file meanwhile
    const std::optional<std::size_t> rank = insert(mode, score);
    if (rank) write();
    return rank;
}

std::optional<std::size_t> HighScores::insert(GameMode mode, const HighScore& score)
{
    std::vector<HighScore>& scores = scores_[mode];
    const auto place = std::upper_bound(scores.begin(), scores.end(), score, is_better);
    const auto rank = static_cast<std::size_t>(place - scores.begin());
    if (rank >= kKept) return std::nullopt;
    scores.insert(place, score);
    if (scores.size() > kKept) scores.resize(kKept);
    return rank;
}

}  // namespace kerf::game
