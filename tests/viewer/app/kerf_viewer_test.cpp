#include <stb_image.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>

#include "tools/program.h"
#include "viewer/app/virtual_display.h"

// The program kerf-viewer as a user runs it.

namespace kerf::test {

using tools::expect_unusable;
using tools::Json;
using tools::Outcome;

namespace {

class KerfViewerTest : public tools::ProgramTest
{
protected:
    /// Records ninety frames of swipes, which know where seed 3 throws its first models.
    void write_swipes() const
    {
        report("--headless --autopilot --seed 3 --frames 90 --draw 0 --size 16x9 --save-script swipes.kerf");
    }

    Json report(const std::string& arguments, const std::string& before = "") const
    {
        const Outcome outcome = kerf(arguments, before);
        EXPECT_EQ(outcome.status, 0) << arguments << ": " << outcome.err;
        EXPECT_EQ(outcome.err, "");
        Json json = Json::parse(outcome.out, nullptr, false);
        EXPECT_FALSE(json.is_discarded()) << outcome.out;
        EXPECT_EQ(json["gl_errors"], 0) << json["gl_messages"];
        return json;
    }

    struct Png
    {
        int width = 0, height = 0;
        int colours = 0;  ///< different ones
    };
    Png read_png(const std::string& name) const
    {
        Png png;
        int channels = 0;
        stbi_uc* const pixels = stbi_load((folder_ / name).c_str(), &png.width, &png.height, &channels, 3);
        if (pixels == nullptr) return png;
        std::vector<int> colours;
        const std::ptrdiff_t size = std::ptrdiff_t{png.width} * png.height;
        for (std::ptrdiff_t i = 0; i < size; ++i)
            colours.push_back((pixels[3 * i] << 16) | (pixels[3 * i + 1] << 8) | pixels[3 * i + 2]);
        stbi_image_free(pixels);
        std::sort(colours.begin(), colours.end());
        png.colours = static_cast<int>(std::unique(colours.begin(), colours.end()) - colours.begin());
        return png;
    }
};

}  // namespace

TEST_F(KerfViewerTest, LooksIntoAModel)
{
    const std::string rook = std::string(KERF_DATA_DIR) + "/models/rook.obj";
    for (const std::string backend : {"halfedge", "linear"}) {
        const Json json =
            report("--headless --scene section --backend " + backend +
                   " --frames 150 --draw 0 --size 160x90 --panel --screenshot " + backend + ".png " + rook);
        const Json& run = json["runs"][0];
        EXPECT_EQ(run["backend"], backend);
        EXPECT_EQ(run["model"], "rook");
        EXPECT_EQ(run["triangles"], 926);
        EXPECT_GE(run["sections"], 149);
        EXPECT_GT(run["section_cpu_ms"]["median"], 0.0);
        EXPECT_EQ(run["last"]["status"], "cut");
        EXPECT_GT(run["last"]["area"], 0.0);
        EXPECT_GT(run["last"]["triangles"], 10);
        EXPECT_GT(run["contours"], 5);
        EXPECT_GT(read_png(backend + ".png").colours, 100);
    }
    for (const char* use : {"--script x", "--save-script x", "--backend halfedge,linear"})
        EXPECT_EQ(kerf("--headless --scene section --frames 2 " + std::string(use)).status, 2) << use;
    expect_unusable(kerf("--headless --scene section --frames 2 nothing.obj"), "nothing.obj");
}

TEST_F(KerfViewerTest, PlaysNinetyFramesOnBothBackEnds)
{
    write_swipes();
    const Json json = report("--headless --backend halfedge,baseline --script swipes.kerf --frames 90 --size 160x90");
    ASSERT_EQ(json["runs"].size(), 2u);
    for (const Json& run : json["runs"]) {
        EXPECT_EQ(run["ticks"], 180);
        EXPECT_EQ(run["frame_ms"]["count"], 90);
        ASSERT_GE(run["cuts"].size(), 2u);
        for (const Json& cut : run["cuts"]) {
            EXPECT_EQ(cut["status"], "cut");
            EXPECT_GT(cut["crossing"], 0);
            EXPECT_GE(cut["pieces"].size(), 2u);
            EXPECT_GT(cut["bytes_uploaded"], 0);
        }
    }
    EXPECT_EQ(json["runs"][0]["backend"], "halfedge");
    EXPECT_EQ(json["runs"][1]["backend"], "baseline/hash");
}

/// What docs/simulation.md promises of two back ends, read from what the program prints: until bodies touch, the log of
/// cuts is the same, and masses differ by less than a millionth of the object as thrown; but a cut through a cap that
/// covers more than its section may find other loops and pieces.
TEST_F(KerfViewerTest, PrintsTheSameLogOfCutsOnBothBackEndsUntilBodiesTouch)
{
    int compared = 0, of_concave_sections = 0, contacts = 0;
    for (const std::string model : {"rook", "horse", "monkey", "pedestal", "barrel", "cube", "sphere"}) {
        SCOPED_TRACE(model);
        const std::string file = " '" KERF_DATA_DIR "/models/" + model + ".obj'", run = "--headless --frames 120 ";
        report(run + "--autopilot --seed 3 --draw 0 --size 16x9 --save-script log.kerf" + file);
        const Json runs =
            report(run + "--draw 0 --size 16x9 --backend halfedge,baseline --script log.kerf" + file)["runs"];
        const Json &ours = runs[0]["cuts"], &theirs = runs[1]["cuts"];
        for (std::size_t i = 0; i < std::max(ours.size(), theirs.size()); ++i) {
            const bool touched =
                (i < ours.size() && ours[i]["contact_before"]) || (i < theirs.size() && theirs[i]["contact_before"]);
            if (touched) ++contacts;
            if (touched) break;
            ASSERT_LT(i, ours.size());
            ASSERT_LT(i, theirs.size());
            const Json &one = ours[i], &other = theirs[i];
            SCOPED_TRACE(one.dump() + "\n" + other.dump());
            EXPECT_TRUE(one["closed_rightly"]) << "the half-edge back end closes every section";
            for (const char* what : {"frame", "object", "model", "status", "crossing", "surface_hash"})
                ASSERT_EQ(one[what], other[what]) << what;
            EXPECT_NEAR(one["section_area"], other["section_area"], 1e-5 * one["section_area"].get<double>());
            const bool alike = one["loops"] == other["loops"] && one["pieces"].size() == other["pieces"].size();
            if (!alike && !other["origin_closed_rightly"]) break;
            ASSERT_TRUE(alike);
            ++compared;
            if (!other["closed_rightly"]) ++of_concave_sections;
            double whole = 0.0;
            for (const Json& piece : ours[0]["pieces"]) whole += piece["mass_kg"].get<double>();
            for (std::size_t p = 0; p < one["pieces"].size(); ++p) {
                const Json &mine = one["pieces"][p], &their = other["pieces"][p];
                for (const char* what : {"id", "side", "surface_hash"}) EXPECT_EQ(mine[what], their[what]) << what;
                EXPECT_NEAR(mine["mass_kg"], their["mass_kg"], 1e-6 * whole);
            }
        }
    }
    EXPECT_GE(compared, 12);
    EXPECT_GE(of_concave_sections, 4);
    EXPECT_GE(contacts, 1) << "pieces meet sooner or later";
}

TEST_F(KerfViewerTest, CountsEveryByteForTheCutThatMadeIt)
{
    report("--headless --autopilot --seed 3 --frames 150 --draw 0 --size 16x9 --save-script bytes.kerf");
    const Json both = report("--headless --backend halfedge,baseline --script bytes.kerf --frames 150 --size 16x9");
    for (const Json& run : both["runs"]) {
        std::uint64_t sum = run["bytes_of_throws"];
        double milliseconds = 0.0;
        ASSERT_GE(run["cuts"].size(), 4u);
        for (const Json& cut : run["cuts"]) {
            EXPECT_EQ(cut["bytes_uploaded"], cut["bytes_to_upload"]) << cut["number"];
            EXPECT_GE(cut["upload_cpu_ms"], 0.0) << cut["number"];
            milliseconds += cut["upload_cpu_ms"].get<double>();
            sum += cut["bytes_uploaded"].get<std::uint64_t>();
        }
        EXPECT_EQ(run["bytes_uploaded"], sum);
        EXPECT_GT(milliseconds, 0.0);
    }
}

/// Hashes are no constants: they differ where states and surfaces do.
TEST_F(KerfViewerTest, PrintsHashesFramesAndPicturesSizesOfThisRun)
{
    write_swipes();
    const std::string run = "--headless --script swipes.kerf --draw 0 --size 32x18 ";
    const Json whole = report(run + "--frames 90"), shorter = report(run + "--frames 89"),
               other = report(run + "--frames 90 --seed 4");
    EXPECT_EQ(whole["width"], 32);
    EXPECT_EQ(whole["height"], 18);
    EXPECT_NE(whole["runs"][0]["state_hash"], shorter["runs"][0]["state_hash"]);
    EXPECT_NE(whole["runs"][0]["state_hash"], other["runs"][0]["state_hash"]);
    std::set<std::string> surfaces;
    std::set<std::int64_t> frames;
    std::size_t pieces = 0;
    ASSERT_GE(whole["runs"][0]["cuts"].size(), 2u);
    for (const Json& cut : whole["runs"][0]["cuts"]) {
        EXPECT_GE(cut["frame"], 0);
        EXPECT_LT(cut["frame"], 90);
        frames.insert(cut["frame"].get<std::int64_t>());
        surfaces.insert(cut["surface_hash"].get<std::string>());
        for (const Json& piece : cut["pieces"]) {
            surfaces.insert(piece["surface_hash"].get<std::string>());
            ++pieces;
        }
    }
    EXPECT_EQ(surfaces.size(), pieces + whole["runs"][0]["cuts"].size()) << "no two surfaces are the same";
    EXPECT_GE(frames.size(), 2u);
}

TEST_F(KerfViewerTest, PlaysNinetyFramesOfEachGameOnBothBackEnds)
{
    for (const std::string scene : {"classic", "arcade", "zen"}) {
        report("--headless --autopilot --scene " + scene +
               " --seed 4 --frames 90 --draw 0 --size 16x9 --save-script played.kerf");
        const Json json =
            report("--headless --backend halfedge,baseline --script played.kerf --frames 90 --size 160x90 --draw 6");
        ASSERT_EQ(json["runs"].size(), 2u);
        for (const Json& run : json["runs"]) {
            EXPECT_EQ(run["scene"], scene);
            EXPECT_EQ(run["frame_ms"]["count"], 15);
            EXPECT_EQ(run["game"]["mode"], scene);
            EXPECT_EQ(run["game"]["phase"], "playing");
            EXPECT_GE(run["game"]["wave"], 1);
            EXPECT_GE(run["game"]["score"], 1);
            EXPECT_EQ(run["game"]["events"][0]["event"], "wave");
            EXPECT_EQ(run["game"]["events"][1]["event"], "thrown");
        }
        EXPECT_EQ(json["runs"][0]["game"]["score"], json["runs"][1]["game"]["score"]);
    }
}

// The games of tests/viewer/game/scripted_games_test.cpp.
TEST_F(KerfViewerTest, PlaysAWholeGameOfEachModeToItsScoreOnBothBackEnds)
{
    for (const auto& [scene, score] : {std::pair("classic", 46), std::pair("arcade", 85), std::pair("zen", 75)}) {
        const Json json = report("--headless --draw 0 --size 16x9 --backend halfedge,baseline --frames 5700 --script " +
                                 std::string(KERF_SCRIPTS_DIR "/") + scene + ".kerf");
        ASSERT_EQ(json["runs"].size(), 2u);
        for (const Json& run : json["runs"]) {
            EXPECT_EQ(run["game"]["mode"], scene);
            EXPECT_EQ(run["game"]["phase"], "over") << scene;
            EXPECT_EQ(run["game"]["score"], score) << scene;
        }
    }
}

TEST_F(KerfViewerTest, PlaysNinetyFramesOfAGiantOnBothBackEnds)
{
    report(
        "--headless --autopilot --scene giant --giant 10000 --frames 90 --draw 0 --size 16x9 --save-script cut.kerf");
    const Json json =
        report("--headless --backend halfedge,baseline --script cut.kerf --frames 90 --size 160x90 --draw 6");
    ASSERT_EQ(json["runs"].size(), 2u);
    for (const Json& run : json["runs"]) {
        EXPECT_EQ(run["scene"], "giant");
        EXPECT_EQ(run["giant"]["triangles"], 10000);
        EXPECT_EQ(run["giant"]["giants"], 1);
        ASSERT_GE(run["cuts"].size(), 2u);
        EXPECT_NEAR(run["cuts"][0]["triangles"].get<double>(), 10000.0, 500.0);
    }
    for (const char* what : {"frame", "object", "crossing", "surface_hash"})
        EXPECT_EQ(json["runs"][0]["cuts"][0][what], json["runs"][1]["cuts"][0][what]);
}

TEST_F(KerfViewerTest, ShattersModelsOnBothBackEnds)
{
    report("--headless --autopilot --scene shatter --frames 110 --draw 0 --size 16x9 --save-script broken.kerf");
    const Json json =
        report("--headless --backend halfedge,baseline --script broken.kerf --frames 110 --size 160x90 --draw 6");
    ASSERT_EQ(json["runs"].size(), 2u);
    for (const Json& run : json["runs"]) {
        EXPECT_EQ(run["scene"], "shatter");
        ASSERT_GE(run["breaks"].size(), 1u);
        EXPECT_EQ(run["breaks"][0]["status"], "done");
        EXPECT_GE(run["breaks"][0]["pieces"], 30);
        EXPECT_EQ(run["breaks"][0]["dropped"], 0);
        EXPECT_GT(run["cracks"][0]["bonds_broken"], 0);
        EXPECT_GE(run["bodies"], 30);
    }
    for (const char* what : {"frame", "object", "pieces", "bonds"})
        EXPECT_EQ(json["runs"][0]["breaks"][0][what], json["runs"][1]["breaks"][0][what]) << what;
}

TEST_F(KerfViewerTest, ShattersAUsersModelAndRepeatsIt)
{
    const std::string run = "--headless --frames 100 --size 32x18 --draw 0 " KERF_DATA_DIR "/models/rook.obj ";
    const Json played = report(run + "--scene shatter --autopilot --save-script rook.kerf")["runs"][0];
    const Json repeated = report(run + "--script rook.kerf")["runs"][0];
    ASSERT_EQ(played["breaks"].size(), repeated["breaks"].size());
    EXPECT_EQ(played["breaks"][0]["model"], "rook");
    EXPECT_EQ(repeated["state_hash"], played["state_hash"]);
}

TEST_F(KerfViewerTest, PiecesComeWhenTheyAreReadyIfNobodyWaits)
{
    const Json run = report(
        "--headless --no-wait --autopilot --scene shatter --frames 400 --size 32x18 --save-script ready.kerf")["runs"]
                                                                                                              [0];
    ASSERT_GE(run["breaks"].size(), 1u) << "a thread has made them, and they are on the card";
    EXPECT_GE(run["breaks"][0]["frame"], run["breaks"][0]["struck_frame"]);
    const Json repeated = report("--headless --script ready.kerf --frames 400 --size 32x18 --draw 0")["runs"][0];
    EXPECT_EQ(repeated["state_hash"], run["state_hash"]) << "the recording says when that was";
}

TEST_F(KerfViewerTest, PlaysADuelByItselfAndTheSameTwice)
{
    const std::string run =
        "--headless --autopilot --scene duel --boulder 2000 --seed 2 --frames 360 --draw 0 --size 16x9";
    const Json once = report(run), again = report(run);
    ASSERT_EQ(once["halves"].size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_GE(once["halves"][i]["cuts"], 5) << "in both halves";
        EXPECT_GE(once["halves"][i]["worst_frame_ms"], once["halves"][i]["longest_cut_ms"]);
        EXPECT_EQ(once["halves"][i]["state_hash"], again["halves"][i]["state_hash"]);
    }
    EXPECT_EQ(once["screen"], "play");
}

TEST_F(KerfViewerTest, LetsTheBackEndsOfADuelBeChosen)
{
    const std::string run = "--headless --scene duel --boulder 1000 --frames 2 --draw 0 --size 16x9 --backend ";
    const auto names = [&](const std::string& backends) {
        const Json halves = report(run + backends)["halves"];
        return halves[0]["backend"].get<std::string>() + " " + halves[1]["backend"].get<std::string>();
    };
    EXPECT_EQ(names("halfedge,baseline"), "halfedge baseline/hash");
    EXPECT_EQ(names("baseline/remap"), "halfedge baseline/remap") << "one meets the default";
    EXPECT_EQ(names("halfedge"), "halfedge baseline/hash");
    EXPECT_EQ(names("baseline,baseline/remap --screenshot a.png"), "baseline/hash baseline/remap");
}

TEST_F(KerfViewerTest, PlaysAScriptToItsEndInADuelAndBehindAScreen)
{
    write("swipe.kerf",
          "kerf-script 1\nscene zen\nbackend baseline/remap\nproxy sphere\n"
          "1000 press -4 0\n500000 move 4 0\n1000000 release 4 1\n");
    const std::string run = "--headless --draw 0 --size 16x9 --script swipe.kerf --screenshot ";
    const Json duel = report(run + "duel.png --scene duel --boulder 1000");
    EXPECT_EQ(read_png("duel.png").width, 16);
    for (const Json& half : duel["halves"]) {
        EXPECT_EQ(half["ticks"], 240) << "a second beyond the last input";
        EXPECT_EQ(half["proxy"], "sphere");
    }
    EXPECT_EQ(duel["halves"][1]["backend"], "baseline/remap") << "it meets the default";
    const Json over = report(run + "over.png --screen over");
    EXPECT_EQ(read_png("over.png").width, 16);
    EXPECT_EQ(over["scene"], "zen");
    EXPECT_EQ(over["runs"][0]["ticks"], 240);
    EXPECT_EQ(over["runs"][0]["backend"], "baseline/remap");
    EXPECT_EQ(over["runs"][0]["proxy"], "sphere");
    const Json said = report(run + "over.png --screen over --backend halfedge --proxy box --frames 2")["runs"][0];
    EXPECT_EQ(said["ticks"], 4);
    EXPECT_EQ(said["backend"], "halfedge");
    EXPECT_EQ(said["proxy"], "box");
    EXPECT_EQ(report("--headless --frames 2 --draw 0 --size 16x9 --screen scores")["scene"], "menu");
}

TEST_F(KerfViewerTest, RecordsTheGameBehindAScreen)
{
    const std::string run = "--headless --draw 0 --size 16x9 --frames 150 ";
    const Json played = report(run + "--scene zen --screen paused --autopilot --save-script played.kerf")["runs"][0];
    const Json repeated = report(run + "--script played.kerf --screen paused")["runs"][0];
    EXPECT_GE(played["cuts"], 1);
    EXPECT_EQ(repeated["state_hash"], played["state_hash"]);
    write("menu.kerf", "kerf-script 1\nscene menu\n");
    expect_unusable(kerf(run + "--screen menu --script menu.kerf --save-script no.kerf"), "not recorded");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "no.kerf"));
}

/// No tick of a run prepares a mesh: another thread has done it before.
TEST_F(KerfViewerTest, ThrowsWhatWasMadeReadyBefore)
{
    const std::string run = "--headless --autopilot --seed 3 --draw 0 --size 16x9 ";
    const Json thrown = report(run + "--frames 300")["runs"][0];
    EXPECT_GE(thrown["bytes_of_throws"], 1);
    EXPECT_EQ(thrown["late_preparations"], 0);
    EXPECT_EQ(thrown["late_copies"], 0);
    const Json game = report(run + "--frames 400 --scene arcade")["runs"][0];
    EXPECT_GE(game["cuts"].size(), 2u);
    EXPECT_EQ(game["late_preparations"], 0);
}

TEST_F(KerfViewerTest, GivesTheSameStateTwice)
{
    write_swipes();
    const std::string run = "--headless --script swipes.kerf --frames 90 --size 32x18 --draw 0 --backend ";
    for (const std::string backend : {"halfedge", "baseline/remap"})
        EXPECT_EQ(report(run + backend)["runs"][0]["state_hash"], report(run + backend)["runs"][0]["state_hash"]);
}

TEST_F(KerfViewerTest, SavesAScriptThatRepeatsTheRun)
{
    const std::string run = "--headless --frames 120 --size 32x18 --draw 0 ";
    const Json played = report(run + "--autopilot --seed 5 --save-script played.kerf")["runs"][0];
    const Json repeated = report(run + "--script played.kerf")["runs"][0];
    EXPECT_GE(played["cuts"].size(), 2u);
    EXPECT_EQ(repeated["seed"], 5);
    EXPECT_EQ(repeated["state_hash"], played["state_hash"]);
    EXPECT_EQ(repeated["cuts"].size(), played["cuts"].size());
}

TEST_F(KerfViewerTest, GivesTheSameStateInAWindow)
{
    write_swipes();
    const VirtualDisplay display;
    const std::string run = "--script swipes.kerf --frames 60 --size 320x180 ";
    const Json in_window = report(run + "--screenshot window.png")["runs"][0];
    const Json without = report(run + "--headless")["runs"][0];
    EXPECT_EQ(in_window["state_hash"], without["state_hash"]);
    ASSERT_GE(in_window["cuts"].size(), 1u);
    ASSERT_EQ(in_window["cuts"].size(), without["cuts"].size());
    for (std::size_t i = 0; i < in_window["cuts"].size(); ++i)
        for (const char* what : {"frame", "object", "surface_hash", "bytes_uploaded", "closed_rightly"})
            EXPECT_EQ(in_window["cuts"][i][what], without["cuts"][i][what]) << what;
    EXPECT_EQ(read_png("window.png").width, 320);
}

TEST_F(KerfViewerTest, PlaysNinetyFramesInAWindowOnBothBackEnds)
{
    write_swipes();
    const VirtualDisplay display;
    for (const std::string backend : {"halfedge", "baseline/hash"}) {
        const Json json = report("--script swipes.kerf --frames 90 --size 320x180 --backend " + backend);
        EXPECT_EQ(json["gl_errors"], 0);
        EXPECT_EQ(json["width"], 320);
        EXPECT_EQ(json["height"], 180);
        const Json& run = json["runs"][0];
        EXPECT_EQ(run["backend"], backend);
        EXPECT_EQ(run["ticks"], 180);
        EXPECT_EQ(run["frame_ms"]["count"], 90);
        ASSERT_GE(run["cuts"].size(), 2u);
        for (const Json& cut : run["cuts"]) EXPECT_GT(cut["bytes_uploaded"], 0);
    }
}

TEST_F(KerfViewerTest, TakesTheFilesAfterOptionsThatTakeLists)
{
    write_swipes();
    const std::string run = "--headless --frames 1 --draw 0 --size 16x9 ",
                      cube = " '" KERF_DATA_DIR "/models/cube.obj'";
    for (const std::string option : {"--backend baseline", "--zoom-at 1.5,-0.5", "--backend halfedge,baseline"})
        EXPECT_EQ(report(run + option + cube)["runs"][0]["bodies"], 1) << option;
    const Json last = report(run + "--backend halfedge,baseline --backend baseline")["runs"];
    ASSERT_EQ(last.size(), 1u) << "the last option counts";
    EXPECT_EQ(last[0]["backend"], "baseline/hash");
}

TEST_F(KerfViewerTest, ReportsWhatCommandsComplainAbout)
{
    write("odd.kerf", "kerf-script 1\n1000 command backend axe\n20000 command throw elephant\n");
    const Outcome outcome = kerf("--headless --frames 5 --draw 0 --size 16x9 --script odd.kerf");
    EXPECT_EQ(outcome.status, 0);
    const Json messages = Json::parse(outcome.out)["messages"];
    ASSERT_EQ(messages.size(), 2u);
    EXPECT_NE(messages[0].get<std::string>().find("axe"), std::string::npos);
    EXPECT_NE(messages[1].get<std::string>().find("elephant"), std::string::npos);
}

TEST_F(KerfViewerTest, SaysThatThereIsNoDisplay)
{
    const Outcome outcome = kerf("", "unset DISPLAY WAYLAND_DISPLAY;");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("no display"), std::string::npos) << outcome.err;
}

TEST_F(KerfViewerTest, WritesPicturesOfTheirSize)
{
    report(
        "--headless --frames 3 --size 200x120 --screenshot last.png --record all --panel --keys --proxies --wireframe");
    const Png last = read_png("last.png");
    EXPECT_EQ(last.width, 200);
    EXPECT_EQ(last.height, 120);
    EXPECT_GT(last.colours, 100);
    EXPECT_EQ(read_png("all/frame_00000.png").width, 200);
    EXPECT_EQ(text_of("all/frame_00002.png"), text_of("last.png"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "all/frame_00003.png"));
}

TEST_F(KerfViewerTest, ARecordingHoldsNoFramesOfAnEarlierOne)
{
    report("--headless --frames 4 --size 16x9 --record all");
    write("all/mine.txt", "mine");
    report("--headless --frames 2 --size 16x9 --record all");
    EXPECT_TRUE(std::filesystem::exists(folder_ / "all/frame_00001.png"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "all/frame_00002.png"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "all/frame_00003.png"));
    EXPECT_TRUE(std::filesystem::exists(folder_ / "all/mine.txt"));
}

TEST_F(KerfViewerTest, EachOptionOfThePictureIsSeen)
{
    const std::string run = "--headless --frames 50 --draw 0 --size 320x180 --seed 2 --screenshot ";
    report(run + "plain.png");
    for (const std::string option : {"panel", "proxies", "wireframe", "keys"}) {
        report(run + option + ".png --" + option);
        EXPECT_NE(text_of(option + ".png"), text_of("plain.png")) << option;
    }
}

TEST_F(KerfViewerTest, DrawsAPictureOfOnePixel)
{
    report("--headless --frames 2 --size 1x1 --panel --screenshot dot.png");
    EXPECT_EQ(read_png("dot.png").width, 1);
}

TEST_F(KerfViewerTest, LightingsGiveDifferentPictures)
{
    const std::string run = "--headless --frames 50 --draw 0 --size 160x90 --seed 2 ";
    report(run + "--lighting lambert --screenshot lambert.png");
    report(run + "--lighting textured --screenshot textured.png");
    EXPECT_NE(text_of("lambert.png"), text_of("textured.png"));
}

TEST_F(KerfViewerTest, ThrowsWhatItCanReadAndSaysWhatItCannot)
{
    write("broken.obj", "v 0 0 nonsense\n");
    const Outcome outcome = kerf("--headless --frames 2 --size 32x18 broken.obj '" KERF_DATA_DIR "/models/cube.obj'");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("broken.obj"), std::string::npos) << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["messages"].size(), 1u);
    EXPECT_EQ(json["runs"][0]["bodies"], 1);
    expect_unusable(kerf("--headless --frames 2 --size 32x18 broken.obj broken.obj"), "broken.obj");
    EXPECT_NE(kerf("--help").out.find(" 1 none of the files can be used "), std::string::npos);
}

TEST_F(KerfViewerTest, AnImageThatIsMissingIsSaidAndTheModelIsDrawn)
{
    write("plain.mtl", "newmtl mine\nKd 0.1 0.2 0.9\nmap_Kd pictures/none.png\n");
    write("plain.obj",
          "mtllib plain.mtl\nusemtl mine\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
          "f 1/1 3/2 2/3\nf 1/1 2/2 4/3\nf 1/1 4/2 3/3\nf 2/1 3/2 4/3\n");
    const Outcome outcome = kerf("--headless --frames 2 --size 32x18 plain.obj");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.error_lines(), 1) << outcome.err;
    EXPECT_NE(outcome.err.find("pictures/none.png"), std::string::npos) << outcome.err;
    const Json json = Json::parse(outcome.out);
    EXPECT_EQ(json["messages"].size(), 1u);
    EXPECT_EQ(json["gl_errors"], 0);
    EXPECT_EQ(json["runs"][0]["bodies"], 1);
}

TEST_F(KerfViewerTest, SaysThatCoordinatesAreCoarseOrTooLarge)
{
    const auto tetrahedron = [](const std::string& offset, const std::string& size) {
        return "v " + offset + " 0 0\nv " + size + " 0 0\nv " + offset + " " + size + " 0\nv " + offset + " 0 " + size +
               "\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
    };
    write("far.obj", tetrahedron("10000000", "10000004"));
    write("huge.obj", tetrahedron("0", "1e25"));
    write("dust.obj", tetrahedron("0", "1e-25"));
    const Outcome outcome = kerf("--headless --frames 2 --draw 0 --size 16x9 far.obj huge.obj dust.obj");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Json messages = Json::parse(outcome.out)["messages"];
    ASSERT_EQ(messages.size(), 3u) << outcome.out;
    EXPECT_NE(messages[0].get<std::string>().find("far.obj: coarse coordinates"), std::string::npos);
    EXPECT_NE(messages[1].get<std::string>().find("huge.obj: the mesh is too large"), std::string::npos);
    EXPECT_NE(messages[2].get<std::string>().find("dust.obj: the mesh is too large or too small"), std::string::npos);
    expect_unusable(kerf("--headless --frames 2 huge.obj"), "huge.obj");
}

TEST_F(KerfViewerTest, NeedsOneModelAtLeast)
{
    expect_unusable(kerf("--headless --frames 2 nowhere.obj"), "nowhere.obj");
}

TEST_F(KerfViewerTest, RefusesBadScripts)
{
    write("bad.kerf", "kerf-script 1\n12 jump 0 0\n");
    expect_unusable(kerf("--headless --script bad.kerf"), "bad.kerf:2");
    expect_unusable(kerf("--headless --script none.kerf"), "none.kerf");
    write("empty.kerf", "");
    expect_unusable(kerf("--headless --script empty.kerf"), "empty.kerf: this is no script");
    write("egg.kerf", "kerf-script 1\nproxy egg\n");
    expect_unusable(kerf("--headless --frames 1 --script egg.kerf"), "egg");
    write("axe.kerf", "kerf-script 1\nscene zen\nbackend axe\n");
    for (const std::string screen : {"", " --screen over"})
        expect_unusable(kerf("--headless --frames 1 --script axe.kerf" + screen), "axe");
}

TEST_F(KerfViewerTest, RefusesScenesThatItCannotPlay)
{
    write("chess.kerf", "kerf-script 1\nscene chess\n12 press 0 0\n");
    expect_unusable(kerf("--headless --script chess.kerf"), "chess");
    expect_unusable(kerf("--headless --frames 2 --scene zen --data ."), "watermelon.glb");
}

TEST_F(KerfViewerTest, LeavesNoHalfAPictureBehind)
{
    expect_unusable(kerf("--headless --frames 1 --size 16x9 --screenshot no/such/folder.png"), "no/such/folder.png");
    EXPECT_TRUE(names_in_folder().empty());
}

TEST_F(KerfViewerTest, NeverReplacesWhatItReads)
{
    namespace fs = std::filesystem;
    write("a.obj", "mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    write("m.mtl", "newmtl m\nmap_Kd skin.png\n");
    write("skin.png", "not really");
    write("s.kerf", "kerf-script 1\n10 press 1 2\n");
    fs::create_hard_link(folder_ / "a.obj", folder_ / "hard");
    fs::create_symlink("s.kerf", folder_ / "link");
    const std::vector<std::string> names = names_in_folder();
    std::vector<std::string> before;
    for (const std::string& name : names) before.push_back(text_of(name));
    const std::string run = "--headless --frames 1 --size 16x9 --draw 0 --script s.kerf a.obj ";
    for (const char* output : {"--screenshot a.obj", "--screenshot ./m.mtl", "--screenshot skin.png",
                               "--screenshot hard", "--save-script s.kerf", "--save-script link"})
        expect_unusable(kerf(run + output), "it would replace what is read");
    expect_unusable(kerf("--headless --scene menu --size 16x9 --script s.kerf --screenshot s.kerf"), "would replace");
    EXPECT_EQ(names_in_folder(), names);
    for (std::size_t i = 0; i < names.size(); ++i) EXPECT_EQ(text_of(names[i]), before[i]) << names[i];
}

TEST_F(KerfViewerTest, ARecordingNeverReplacesWhatItReads)
{
    namespace fs = std::filesystem;
    fs::create_directory(folder_ / "rec");
    const std::string solid = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    write("rec/m.obj", "mtllib m.mtl\nusemtl m\n" + solid);
    write("rec/m.mtl", "newmtl m\nmap_Kd frame_00000.png\n");
    write("rec/frame_00000.png", "a skin");
    write("a.obj", solid);
    fs::create_directory(folder_ / "linked");
    fs::create_symlink("../s.kerf", folder_ / "linked/frame_00001.png");
    write("s.kerf", "kerf-script 1\n10 press 1 2\n");
    const std::string run = "--headless --frames 2 --size 16x9 --script s.kerf ";
    expect_unusable(kerf(run + "--record rec rec/m.obj"), "it would replace what is read");
    expect_unusable(kerf(run + "--record linked a.obj"), "it would replace what is read");
    expect_unusable(kerf(run + "--scene menu --record linked"), "it would replace what is read");
    EXPECT_EQ(text_of("rec/frame_00000.png"), "a skin");
    EXPECT_EQ(text_of("s.kerf"), "kerf-script 1\n10 press 1 2\n");
    // Frames of an earlier recording are nobody's input.
    report(run + "--record rec a.obj");
    EXPECT_EQ(read_png("rec/frame_00001.png").width, 16);
}

TEST_F(KerfViewerTest, NeverWritesTwoFilesToOnePlace)
{
    namespace fs = std::filesystem;
    fs::create_directory(folder_ / "rec");
    fs::create_symlink("same", folder_ / "link");
    fs::create_symlink("rec/frame_00007.png", folder_ / "seven");
    const std::vector<std::string> names = names_in_folder();
    const std::string run = "--headless --frames 2 --size 16x9 '" KERF_DATA_DIR "/models/cube.obj' ";
    for (const char* outputs :
         {"--screenshot same --save-script same", "--screenshot ./same --save-script link",
          "--screenshot rec/frame_00001.png --record rec", "--screenshot new/frame_00001.png --record ./new",
          "--save-script seven --record rec/../rec"})
        expect_unusable(kerf(run + outputs), "another file of the same call");
    EXPECT_EQ(names_in_folder(), names);
    report(run + "--screenshot frame_00000.png --save-script same --record rec");
    EXPECT_EQ(read_png("frame_00000.png").width, 16);
}

TEST_F(KerfViewerTest, TheGameNeverReplacesItsFruit)
{
    namespace fs = std::filesystem;
    fs::create_directory(folder_ / "data");
    fs::copy(KERF_DATA_DIR "/fruit", folder_ / "data/fruit", fs::copy_options::recursive);
    const std::string melon = text_of("data/fruit/watermelon.glb");
    for (const char* scene : {"menu", "zen"})
        expect_unusable(
            kerf("--headless --frames 1 --size 16x9 --data data --screenshot data/fruit/watermelon.glb --scene " +
                 std::string(scene)),
            "it would replace what is read");
    EXPECT_EQ(text_of("data/fruit/watermelon.glb"), melon);
}

TEST_F(KerfViewerTest, FindsItsDataFromWhereItIsInstalled)
{
    namespace fs = std::filesystem;
    // On the search path, by a link, and in a folder of its own.
    fs::create_directories(folder_ / "usr/bin");
    fs::create_directories(folder_ / "usr/share/kerf/models");
    fs::copy_file(KERF_PROGRAM, folder_ / "usr/bin/kerf-viewer");
    fs::create_symlink("usr/bin/kerf-viewer", folder_ / "link");
    const auto run = [&] {
        const std::string program = "'" + (folder_ / "link").string() + "'";
        return std::system((program + " --headless --scene report --frames 2 --draw 0 > '" +
                            (folder_ / "report").string() + "' 2> '" + (folder_ / "problems").string() + "'")
                               .c_str());
    };
    EXPECT_NE(run(), 0);
    EXPECT_NE(text_of("problems").find((folder_ / "usr/share/kerf/models").string()), std::string::npos)
        << text_of("problems");
    fs::copy(KERF_DATA_DIR "/models", folder_ / "usr/share/kerf/models", fs::copy_options::recursive);
    EXPECT_EQ(run(), 0) << text_of("problems");
}

TEST_F(KerfViewerTest, SaysHowManyPiecesHadRoom)
{
    // Tetrahedra through one another: each is a piece.
    std::string soup;
    for (int i = 0; i < 400; ++i) {
        const double x = 0.3 * std::sin(i), y = 0.3 * std::cos(3.0 * i), z = 0.3 * std::sin(7.0 * i);
        for (const auto& [a, b, c] : {std::tuple{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
            soup += "v " + std::to_string(x + a) + " " + std::to_string(y + b) + " " + std::to_string(z + c) + "\n";
        soup += "f -4 -2 -3\nf -4 -3 -1\nf -3 -2 -1\nf -2 -4 -1\n";
    }
    write("soup.obj", soup);
    const Outcome outcome = kerf("--headless --autopilot --seed 3 --frames 90 --draw 0 --size 16x9 soup.obj");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.err.find(" pieces: there is room for "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("left out are those where 64 others are already"), std::string::npos) << outcome.err;
    const Json json = Json::parse(outcome.out, nullptr, false);
    ASSERT_FALSE(json.is_discarded());
    EXPECT_FALSE(json["messages"].empty());
    EXPECT_LT(json["runs"][0]["bodies"], 400);
}

TEST_F(KerfViewerTest, ExplainsWrongUse)
{
    for (const char* arguments : {"--size 12",
                                  "--size 0x5",
                                  "--backend magic",
                                  "--headless",
                                  "--frames -3",
                                  "--what",
                                  "--backend halfedge,baseline --frames 3",
                                  "--headless --frames 3 --backend halfedge,baseline --screenshot a.png",
                                  "--headless --frames 3 --backend halfedge,baseline --scene menu",
                                  "--headless --frames 3 --backend halfedge,baseline --scene zen --screen over",
                                  "--scene menu --frames 3",
                                  "--scene duel --autopilot",
                                  "--scene duel --script a.kerf",
                                  "--scene menu --record all",
                                  "--scene duel --save-script a.kerf",
                                  "--headless --frames 3 --scene duel --save-script a.kerf",
                                  "--headless --frames 3 --screen scores --save-script a.kerf",
                                  "--seed -5",
                                  "--seed 18446744073709551616",
                                  "--scene chess",
                                  "--zoom nan",
                                  "--zoom 0.5",
                                  "--ui-scale nan",
                                  "--ui-scale 9",
                                  "--zoom-at nan,0",
                                  "--zoom-at 0,inf",
                                  "--zoom-at 1",
                                  "--zoom-at 1,2,3",
                                  "--giant 5",
                                  "--headless --frames 3 --scene duel --backend halfedge,baseline,baseline",
                                  "--headless --frames 3 --scene zen a.obj"}) {
        const Outcome outcome = kerf(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_EQ(outcome.error_lines(), 2) << arguments << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "");
    }
    EXPECT_EQ(kerf("--help").status, 0);
    EXPECT_EQ(kerf("--version").status, 0);
}

}  // namespace kerf::test
