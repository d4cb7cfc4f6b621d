#include "viewer/game/stored_settings.h"

#include <optional>

#include "viewer/game/giant_sizes.h"

namespace kerf::game {
namespace {

constexpr const char* kSettingsFormat = "kerf-settings";

std::string objection_to_settings(const nlohmann::json& json)
{
    return json.is_object() && json.value("format", nlohmann::json()) == kSettingsFormat
               ? ""
               : "it holds no settings of Kerf";
}

std::filesystem::path file_in(const std::filesystem::path& folder)
{
    return folder / "settings.json";
}

void read(const nlohmann::json& json, const char* key, bool& value)
{
    if (json.contains(key) && json[key].is_boolean()) json[key].get_to(value);
}

void read(const nlohmann::json& json, const char* key, std::string& value)
{
    if (json.contains(key) && json[key].is_string()) json[key].get_to(value);
}

void read(const nlohmann::json& json, const char* key, double& value, double least, double most)
{
    if (!json.contains(key) || !json[key].is_number()) return;
    const double number = json[key].get<double>();
    if (number >= least && number <= most) value = number;
}

void read(const nlohmann::json& json, const char* key, std::int64_t& value, std::int64_t least, std::int64_t most)
{
    if (!json.contains(key) || !json[key].is_number_integer()) return;
    const auto number = json[key].get<std::int64_t>();
    if (number >= least && number <= most) value = number;
}

}  // namespace

LoadedSettings load_settings(const std::filesystem::path& folder)
{
    LoadedSettings loaded;
    if (folder.empty()) return loaded;
    const StoredJson stored = load_json(file_in(folder), objection_to_settings);
    loaded.message = stored.message;
    if (stored.value.is_null()) return loaded;
    StoredSettings& settings = loaded.settings;
    read(stored.value, "volume", settings.volume, 0.0, 1.0);
    read(stored.value, "mute", settings.mute);
    read(stored.value, "backend", settings.backend);
    read(stored.value, "scene", settings.scene);
    read(stored.value, "fullscreen", settings.fullscreen);
    read(stored.value, "window_scale", settings.window_scale, 0.5, 3.0);
    read(stored.value, "vsync", settings.vsync);
    read(stored.value, "giant", settings.giant, kFewestGiantTriangles, kMostGiantTriangles);
    return loaded;
}

std::string save_settings(const std::filesystem::path& folder, const StoredSettings& settings)
{
    if (folder.empty()) return {};
    StoredJson stored = load_json(file_in(folder), objection_to_settings);
    if (!stored.is_free) return stored.message;
    nlohmann::json json = stored.value.is_null() ? nlohmann::json::object() : std::move(stored.value);
    json["format"] = kSettingsFormat;
    json["volume"] = settings.volume;
    json["mute"] = settings.mute;
    json["backend"] = settings.backend;
    json["scene"] = settings.scene;
    json["fullscreen"] = settings.fullscreen;
    json["window_scale"] = settings.window_scale;
    json["vsync"] = settings.vsync;
    json["giant"] = settings.giant;
    return save_json(file_in(folder), json);
}

}  // namespace kerf::game
