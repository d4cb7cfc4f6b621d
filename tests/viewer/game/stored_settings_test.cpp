#include "viewer/game/stored_settings.h"

#include <nlohmann/json.hpp>

#include "support/temporary_folder.h"

namespace kerf::game {
namespace {

using Json = nlohmann::json;

class StoredSettingsTest : public test::FolderTest
{
};

StoredSettings unusual()
{
    StoredSettings settings;
    settings.volume = 0.25;
    settings.mute = true;
    settings.backend = "baseline/hash";
    settings.scene = "zen";
    settings.fullscreen = true;
    settings.window_scale = 1.5;
    settings.vsync = false;
    settings.giant = 2'000'000;
    return settings;
}

}  // namespace

TEST_F(StoredSettingsTest, AreTheDefaultsAtFirst)
{
    const LoadedSettings loaded = load_settings(folder_);
    EXPECT_EQ(loaded.settings, StoredSettings());
    EXPECT_EQ(loaded.message, "");
}

TEST_F(StoredSettingsTest, AreThereInTheNextProgram)
{
    EXPECT_EQ(save_settings(folder_, unusual()), "");
    EXPECT_EQ(load_settings(folder_).settings, unusual());
}

TEST_F(StoredSettingsTest, TakeTheDefaultForEachValueThatMakesNoSense)
{
    Json json{{"format", "kerf-settings"}, {"volume", 2.0},     {"mute", "yes"}, {"scene", "zen"}, {"giant", 3},
              {"window_scale", ""},        {"fullscreen", true}};
    write("settings.json", json.dump());
    StoredSettings expected;
    expected.scene = "zen";
    expected.fullscreen = true;
    const LoadedSettings loaded = load_settings(folder_);
    EXPECT_EQ(loaded.settings, expected);
    EXPECT_EQ(loaded.message, "");
}

TEST_F(StoredSettingsTest, SetADamagedFileAside)
{
    write("settings.json", "{\"volume\": 0.");
    const LoadedSettings loaded = load_settings(folder_);
    EXPECT_EQ(loaded.settings, StoredSettings());
    EXPECT_NE(loaded.message.find("settings.json.damaged"), std::string::npos) << loaded.message;
    EXPECT_TRUE(exists("settings.json.damaged"));
}

TEST_F(StoredSettingsTest, LeaveWhatALaterVersionStoredAlone)
{
    write("settings.json", Json{{"format", "kerf-settings"}, {"blade_colour", "blue"}}.dump());
    EXPECT_EQ(save_settings(folder_, unusual()), "");
    EXPECT_EQ(Json::parse(text_of("settings.json"))["blade_colour"], "blue");
    EXPECT_EQ(load_settings(folder_).settings, unusual());
}

TEST_F(StoredSettingsTest, WorkWithoutAFolder)
{
    EXPECT_EQ(save_settings({}, unusual()), "");
    EXPECT_EQ(load_settings({}).settings, StoredSettings());
}

}  // namespace kerf::game
