#include <cmath>
#include <set>
#include <sstream>

#include "common/io/mesh_file.h"
#include "tools/program.h"

namespace kerf::tools {
namespace {

class KerfCut : public ProgramTest
{
protected:
    void make(const std::string& shape, int triangles) const
    {
        ASSERT_EQ(kerf("shape " + shape + " --triangles " + std::to_string(triangles) + " -o in.ply").status, 0);
    }
    /// Names in the folder other than the input's.
    std::vector<std::string> written() const
    {
        std::vector<std::string> names = names_in_folder();
        std::erase(names, "in.ply");
        return names;
    }
};

TEST_F(KerfCut, WritesBothSidesAndSaysWhatItDid)
{
    make("asteroid", 2000);
    const Json whole = kerf_json("info in.ply");
    const Json cut = kerf_json("cut in.ply --normal 1,2,3 --out half");
    EXPECT_EQ(written(), (std::vector<std::string>{"half.negative.obj", "half.positive.obj"}));
    EXPECT_EQ(cut["status"], "cut");
    EXPECT_EQ(cut["counts"]["triangles"], whole["triangles"]);
    EXPECT_GT(cut["counts"]["crossing"], 0);
    EXPECT_EQ(cut["counts"]["loops"], 1);
    double volume = 0.0, surface = 0.0;
    for (const char* side : {"positive", "negative"}) {
        const Json& s = cut[side];
        EXPECT_EQ(s["closed"], true);
        EXPECT_GT(s["triangles"], 0);
        EXPECT_NEAR(s["area"].get<double>(), s["surface_area"].get<double>() + s["cap_area"].get<double>(), 1e-9);
        EXPECT_EQ(s["centre_of_mass"].size(), 3u);
        volume += s["volume"].get<double>();
        surface += s["surface_area"].get<double>();

        const Json read = kerf_json("info half." + std::string(side) + ".obj");
        EXPECT_EQ(read["triangles"], s["triangles"]);
        EXPECT_EQ(read["closed"], true);
        EXPECT_NEAR(read["volume"].get<double>(), s["volume"].get<double>(), 1e-6);
        EXPECT_NEAR(read["area"].get<double>(), s["area"].get<double>(), 1e-6);
    }
    EXPECT_NEAR(volume, whole["volume"].get<double>(), 1e-6 * volume);
    EXPECT_NEAR(surface, whole["area"].get<double>(), 1e-6 * surface);
    const Json& time = cut["time_ms"];
    EXPECT_GT(time["prepare"], 0.0);
    EXPECT_GT(time["cut"], 0.0);
    double phases = 0.0;
    for (const auto& [name, ms] : time["phases"].items()) phases += ms.get<double>();
    EXPECT_GT(phases, 0.0);
    EXPECT_LE(phases, time["cut"]);
}

TEST_F(KerfCut, PutsThePlaneThroughTheCentreOfTheBoundsUnlessAPointIsGiven)
{
    write("box.obj", "v 2 0 0\nv 4 0 0\nv 2 1 0\nv 2 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    const Json middle = kerf_json("cut box.obj --normal 10,0,0 --out a");
    EXPECT_EQ(middle["plane"]["normal"], Json({1.0, 0.0, 0.0}));
    EXPECT_EQ(middle["plane"]["offset"], 3.0);
    EXPECT_NEAR(middle["positive"]["volume"].get<double>() * 8, 2.0 / 6.0, 1e-6);
    const Json moved = kerf_json("cut box.obj --normal -1,0,0 --point 2.5,7,-.5 --out a");
    EXPECT_EQ(moved["plane"]["offset"], -2.5);
    EXPECT_NEAR(moved["negative"]["volume"].get<double>(), 2.0 / 6.0 * 27.0 / 64.0, 1e-6);
    EXPECT_LT(moved["positive"]["centre_of_mass"][0], 2.5);
}

TEST_F(KerfCut, NamesTheGroupsAndMaterialsOfObjFiles)
{
    make("box", 12);
    kerf_json("cut in.ply --normal 0,0,1 --out a");
    std::vector<std::string> structure;
    std::istringstream lines(text_of("a.positive.obj"));
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with("g ") || line.starts_with("usemtl ")) structure.push_back(line);
    ASSERT_EQ(structure.size(), 4u);
    EXPECT_EQ(structure[0], "g surface");
    EXPECT_EQ(structure[2], "g cap");
    EXPECT_NE(structure[1], structure[3]);
}

TEST_F(KerfCut, WritesComponentsOneByOne)
{
    make("comb", 100);
    const Json info = kerf_json("info in.ply");
    const double top = info["bounds"]["max"][1], bottom = info["bounds"]["min"][1];
    const Json cut = kerf_json("cut in.ply --normal 0,1,0 --point 0," + std::to_string(bottom + 0.75 * (top - bottom)) +
                               ",0 --components --out part --format ply");
    const Json& teeth = cut["positive"]["pieces"];
    ASSERT_GE(teeth.size(), 2u);
    EXPECT_EQ(cut["negative"]["pieces"].size(), 1u);
    EXPECT_EQ(cut["counts"]["loops"], teeth.size());
    std::set<std::string> expected{"part.negative.0.ply"};
    double volume = 0.0;
    for (std::size_t i = 0; i < teeth.size(); ++i) {
        expected.insert("part.positive." + std::to_string(i) + ".ply");
        EXPECT_EQ(teeth[i]["file"], "part.positive." + std::to_string(i) + ".ply");
        EXPECT_EQ(teeth[i]["closed"], true);
        EXPECT_EQ(kerf_json("info part.positive." + std::to_string(i) + ".ply")["shells"], 1);
        volume += teeth[i]["volume"].get<double>();
    }
    const auto names = written();
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()), expected);
    EXPECT_NEAR(volume, cut["positive"]["volume"].get<double>(), 1e-9);
}

TEST_F(KerfCut, WritesEveryFormatThatItReadsBackClosed)
{
    make("torus", 500);
    for (const std::string format : {"obj", "ply", "stl", "glb"}) {
        const Json cut = kerf_json("cut in.ply --normal 1,0.2,0.1 --out a --format " + format);
        for (const std::string side : {"positive", "negative"}) {
            const Json info = kerf_json("info a." + side + "." + format);
            EXPECT_EQ(info["triangles"], cut[side]["triangles"]) << format;
            EXPECT_NEAR(info["volume"].get<double>(), cut[side]["volume"].get<double>(), 1e-6) << format;
        }
    }
}

TEST_F(KerfCut, SaysSoWhenThePlaneMissesAndWritesNothing)
{
    make("icosphere", 80);
    EXPECT_EQ(kerf_json("cut in.ply --normal 0,0,1 --point 0,0,5 --out a")["status"], "missed");
    const Outcome outcome = kerf("cut in.ply --normal 0,0,1 --point 0,0,-5 --out a");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("missed"), std::string::npos);
    EXPECT_TRUE(written().empty());
}

TEST_F(KerfCut, LeavesTheSectionOpenWhenAskedTo)
{
    make("icosphere", 80);
    const Json cut = kerf_json("cut in.ply --normal 0,1,1 --no-cap --out a");
    EXPECT_EQ(cut["positive"]["closed"], false);
    EXPECT_EQ(cut["positive"]["cap_area"], 0.0);
    EXPECT_GT(cut["section_area"], 0.0);
}

TEST_F(KerfCut, CutsOpenMeshesAndSaysSo)
{
    write("open.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    const Json cut = kerf_json("cut open.obj --normal 1,0.5,0 --out a");
    EXPECT_EQ(cut["status"], "open_section");
    EXPECT_EQ(cut["counts"]["open_chains"], 1);
    EXPECT_EQ(cut["positive"]["closed"], false);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "a.positive.obj"));
    EXPECT_NE(kerf("cut open.obj --normal 1,0.5,0 --out a").out.find("the mesh is open"), std::string::npos);
}

TEST_F(KerfCut, GivesTheSameBytesOnEveryRunAndWithEveryLookup)
{
    make("asteroid", 1000);
    kerf_json("cut in.ply --normal 1,1,0 --out first");
    for (const std::string lookup : {"hash", "remap", "two_bucket_hash", "scan"}) {
        const Json cut = kerf_json("cut in.ply --normal 1,1,0 --out again --lookup " + lookup);
        EXPECT_NE(cut["backend"].get<std::string>().find(lookup), std::string::npos);
        for (const std::string side : {".positive.obj", ".negative.obj"}) {
            const io::LoadedMesh a = io::read_mesh(folder_ / ("first" + side)),
                                 b = io::read_mesh(folder_ / ("again" + side));
            EXPECT_EQ(a.facts.triangles, b.facts.triangles);
            EXPECT_EQ(a.facts.volume, b.facts.volume) << lookup;
            if (lookup == "hash") {
                EXPECT_EQ(text_of("first" + side), text_of("again" + side));
            }
        }
    }
}

TEST_F(KerfCut, LeavesNothingBehindWhenOneFileCannotBeWritten)
{
    make("icosphere", 80);
    std::filesystem::create_directories(folder_ / "a.negative.obj");
    expect_unusable(kerf("cut in.ply --normal 0,1,1 --out a"), "a.negative.obj");
    EXPECT_EQ(written(), std::vector<std::string>{"a.negative.obj"});
    expect_unusable(kerf("cut in.ply --normal 0,1,1 --out gone/a"), "gone/a.positive.obj: it cannot be written");
}

TEST_F(KerfCut, LeavesNothingBehindWhenTheDiskIsFull)
{
    make("icosphere", 2000);
    // A limit of the size of files fails in the same way, if the signal is ignored.
    for (const std::string format : {"obj", "ply", "stl", "glb"}) {
        const Outcome outcome =
            kerf("cut in.ply --normal 0,1,1 --out a --format " + format, "trap '' XFSZ; ulimit -f 20;");
        expect_unusable(outcome, "a.positive." + format + ": it cannot be written");
        EXPECT_TRUE(written().empty()) << format;
    }
}

TEST_F(KerfCut, KeepsTheOldFilesWhenNewOnesCannotBeWritten)
{
    make("icosphere", 2000);
    write("a.positive.stl", "old");
    EXPECT_EQ(kerf("cut in.ply --normal 0,1,1 --out a --format stl", "trap '' XFSZ; ulimit -f 20;").status, 1);
    EXPECT_EQ(text_of("a.positive.stl"), "old");
    EXPECT_EQ(written(), std::vector<std::string>{"a.positive.stl"});
}

/// A prism over a bow tie: one of its lobes is inside out, and no cap has the area of the section.
constexpr const char* kBowTie =
    "v 0 -1 0\nv 2 -1 2.1\nv 2 -1 0\nv 0 -1 2\nv 0 1 0\nv 2 1 2.1\nv 2 1 0\nv 0 1 2\nv 1 -1 0.9\nv 1 1 0.9\n"
    "f 1 5 6\nf 1 6 2\nf 9 1 2\nf 10 6 5\nf 2 6 7\nf 2 7 3\nf 9 2 3\nf 10 7 6\n"
    "f 3 7 8\nf 3 8 4\nf 9 3 4\nf 10 8 7\nf 4 8 5\nf 4 5 1\nf 9 4 1\nf 10 5 8\n";

TEST_F(KerfCut, WarnsWhereCapsCoverMoreThanTheSection)
{
    write("bow.obj", kBowTie);
    make("icosphere", 80);
    for (const std::string backend : {"baseline", "halfedge"}) {
        const std::string options = " --normal 0.01,1,0.02 --out a --backend " + backend;
        EXPECT_EQ(kerf_json("cut bow.obj" + options)["warnings"], Json{"caps_exceed_section"}) << backend;
        EXPECT_NE(kerf("cut bow.obj" + options).out.find("which is not the section's"), std::string::npos) << backend;
        EXPECT_EQ(kerf_json("cut bow.obj --no-cap" + options)["warnings"], Json::array()) << backend;
        EXPECT_EQ(kerf_json("cut in.ply" + options)["warnings"], Json::array()) << backend;
    }
}

TEST_F(KerfCut, RefusesAPrefixThatNamesNoFile)
{
    make("icosphere", 80);
    for (const std::string prefix : {"''", "./", "gone/"}) {
        const Outcome outcome = kerf("cut in.ply --normal 0,1,1 --out " + prefix);
        EXPECT_EQ(outcome.status, 2) << prefix;
        EXPECT_NE(outcome.err.find("names no file"), std::string::npos) << outcome.err;
    }
    EXPECT_TRUE(written().empty());
}

TEST_F(KerfCut, RefusesFilesThatCannotBeUsedInOneLine)
{
    write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    expect_unusable(kerf("cut broken.obj --normal 0,1,0 --out a"), "broken.obj: line 4");
    expect_unusable(kerf("cut none.glb --normal 0,1,0 --out a --json"), "none.glb: there is no such file");
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"broken.obj"});
}

TEST_F(KerfCut, SaysWhenTheFanDoesNotFitTheSection)
{
    make("torus", 2000);
    // Across the axis: two rings, one inside the other, which no fan from the middle covers.
    const Outcome outcome = kerf("cut in.ply --normal 0,0,1 --point 0,0,0.01 --out a");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("the fan does not fit"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace kerf::tools
