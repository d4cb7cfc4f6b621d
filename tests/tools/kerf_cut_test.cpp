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

TEST_F(KerfCut, GoesThroughThreePointsAndTakesAGapAway)
{
    make("box", 12);  // of one unit
    const Json by_points = kerf_json("cut in.ply --through 0.1,0,0 0.1,1,0 0.1,0,1 --out a");
    const Json by_axis = kerf_json("cut in.ply --plane x=0.1 --out b");
    for (const char* side : {"positive", "negative"})
        EXPECT_NEAR(by_points[side]["volume"].get<double>(), by_axis[side]["volume"].get<double>(), 1e-6);
    const Json with_gap = kerf_json("cut in.ply --plane x=0 --gap 0.2 --out c");
    for (const char* side : {"positive", "negative"}) EXPECT_NEAR(with_gap[side]["volume"].get<double>(), 0.4, 1e-6);
    for (const char* use : {"--through 0,0,0 1,0,0", "--through 0,0,0 1,0,0 2,0,0", "--through 0,0,0 1,0,0 0,1,x",
                            "--through 0,0,0 1,0,0 0,1,0 --plane x=0", "--plane x=0 --gap -1", "--plane x=0 --gap nan"})
        EXPECT_EQ(kerf("cut in.ply " + std::string(use) + " --out d").status, 2) << use;
}

TEST_F(KerfCut, CutsOnePlaceAlone)
{
    make("comb", 100);
    const Json whole = kerf_json("info in.ply");
    const Json& bounds = whole["bounds"];
    bool is_across = false;
    for (const char* axis : {"x", "y", "z"}) {
        const int i = axis[0] - 'x';
        const double middle = 0.5 * (bounds["min"][i].get<double>() + bounds["max"][i].get<double>()) + 0.01;
        const std::string plane = std::string(axis) + "=" + std::to_string(middle);
        const Json cut = kerf_json("cut in.ply --plane " + plane + " --out a");
        if (cut["counts"]["loops"].get<int>() < 2) continue;
        const Json one = kerf_json("cut in.ply --plane " + plane + " --only 0,0,0 --out b");
        EXPECT_EQ(one["counts"]["loops"], 1);
        double volume = 0.0;
        for (const char* side : {"positive", "negative"}) {
            EXPECT_EQ(one[side]["closed"], true);
            volume += one[side]["volume"].get<double>();
        }
        EXPECT_NEAR(volume, whole["volume"].get<double>(), 1e-5 * volume);
        const Json solid = kerf_json("cut in.ply --plane " + plane + " --only-solid 0,0,0 --out c");
        EXPECT_EQ(solid["counts"]["loops"], cut["counts"]["loops"]);
        is_across = true;
    }
    EXPECT_TRUE(is_across);
    for (const char* use :
         {"--only 0,0", "--only 0,0,nan", "--only 0,0,0 --gap 0.1", "--only 0,0,0 --only-solid 0,0,0"})
        EXPECT_EQ(kerf("cut in.ply --plane x=0.05 " + std::string(use) + " --out d").status, 2) << use;
}

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

/// A step with a flat floor at z = 0.1, which as a float is 0.100000001, and a wall at x = 0.3, which is 0.300000012.
constexpr const char* kStep =
    "v 0 0 0\nv 1 0 0\nv 1 0 0.1\nv 0.3 0 0.1\nv 0.3 0 1\nv 0 0 1\n"
    "v 0 1 0\nv 1 1 0\nv 1 1 0.1\nv 0.3 1 0.1\nv 0.3 1 1\nv 0 1 1\n"
    "f 1 2 3 4 5 6\nf 12 11 10 9 8 7\n"
    "f 2 1 7 8\nf 3 2 8 9\nf 4 3 9 10\nf 5 4 10 11\nf 6 5 11 12\nf 1 6 12 7\n";

TEST_F(KerfCut, ACoordinateThatIsCopiedFromTheFileMeansThatVertex)
{
    write("step.obj", kStep);
    for (const char* backend : {"", " --backend baseline"})
        for (const char* plane : {"--normal 0,0,1 --point 0,0,0.1", "--normal 0,0,1 --point +7,-3,+.1e0",
                                  "--plane z=0.1", "--plane z=+1e-1", "--plane=-z=0.1"}) {
            SCOPED_TRACE(plane + std::string(backend));
            const Json cut = kerf_json("cut step.obj --out a " + std::string(plane) + backend);
            // Not the floor's area as well: it is no part of the tower above.
            EXPECT_NEAR(cut["section_area"].get<double>(), 0.3, 1e-6);
            const bool is_turned = std::string(plane).find("=-") != std::string::npos;
            EXPECT_NEAR(cut[is_turned ? "negative" : "positive"]["area"].get<double>(), 2.6 * 0.9 + 2 * 0.3, 1e-6);
            EXPECT_EQ(std::abs(cut["plane"]["offset"].get<double>()), double(0.1f));
        }
}

TEST_F(KerfCut, SaysWhatTheReaderWasLenientAboutAsInfoDoes)
{
    const std::string solid =
        "facet\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
        "facet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\n"
        "facet\nouter loop\nvertex 0 0 0\nvertex 0 0 1\nvertex 0 1 0\nendloop\nendfacet\n"
        "facet\nouter loop\nvertex 1 0 0\nvertex 0 1 0\nvertex 0 0 1\nendloop\nendfacet\n";
    write("a.stl", "solid a\n" + solid);
    const Json notes = kerf_json("info a.stl")["notes"];
    ASSERT_EQ(notes.size(), 1u);
    for (const char* plane : {"x=0.25", "x=7"}) {
        EXPECT_EQ(kerf_json("cut a.stl --out b --plane " + std::string(plane))["notes"], notes);
        const Outcome outcome = kerf("cut a.stl --out b --plane " + std::string(plane));
        EXPECT_EQ(outcome.status, 0);
        EXPECT_EQ(outcome.out.find("note: 1 " + notes[0]["what"].get<std::string>() + "\n"), 0u) << outcome.out;
    }
    write("b.stl", "solid b\n" + solid + "endsolid\n");
    EXPECT_EQ(kerf_json("cut b.stl --out b --plane x=0.25")["notes"], Json::array());
    EXPECT_EQ(kerf("cut b.stl --out b --plane x=0.25").out.find("note"), std::string::npos);
}

TEST_F(KerfCut, TakesAPlaneAcrossAnAxis)
{
    write("step.obj", kStep);
    const Json wall = kerf_json("cut step.obj --plane x=0.3 --out a");
    EXPECT_EQ(wall["plane"], Json({{"normal", {1.0, 0.0, 0.0}}, {"offset", double(0.3f)}}));
    EXPECT_NEAR(wall["section_area"].get<double>(), 0.1, 1e-6);
    const Json turned = kerf_json("cut step.obj --plane=-y=.25 --out a");
    EXPECT_EQ(turned["plane"], Json({{"normal", {0.0, -1.0, 0.0}}, {"offset", -0.25}}));
    EXPECT_NEAR(turned["positive"]["volume"].get<double>() * 3, turned["negative"]["volume"].get<double>(), 1e-6);
    // No mesh has such coordinates: what is no float stays what it is.
    EXPECT_EQ(kerf_json("cut step.obj --plane z=1e300 --out a")["status"], "missed");
    EXPECT_EQ(kerf_json("cut step.obj --plane z=1e-300 --out a")["plane"]["offset"], 0.0);
    for (const char* plane : {"w=1", "x", "x=", "=1", "x=nan", "x=inf", "x=+-1", "x=1e999", "x=1,2", "xy=1", "--x=1",
                              "x=1 --normal 1,0,0", "x=1 --point 0,0,0"}) {
        const Outcome outcome = kerf("cut step.obj --out a --plane=" + std::string(plane));
        EXPECT_EQ(outcome.status, 2) << plane;
        EXPECT_NE(outcome.err.find("--plane"), std::string::npos) << outcome.err;
    }
}

TEST_F(KerfCut, ANumberBeyondTheDoublesIs0OrTooLargeAsInFiles)
{
    write("step.obj", kStep);
    for (const char* plane : {"--plane y=1e-400", "--plane y=-1e-999", "--plane=-y=0.1e-9999",
                              "--normal 0,1,0 --point 0,1e-400,0", "--normal 1e-400,1,-1e-400 --point 0,-1e-400,1"}) {
        const Json cut = kerf_json("cut step.obj --out a " + std::string(plane));
        EXPECT_EQ(cut["plane"]["offset"], 0.0) << plane;
        EXPECT_EQ(std::abs(cut["plane"]["normal"][1].get<double>()), 1.0) << plane;
    }
    const std::string zeros(400, '0');
    EXPECT_EQ(kerf_json("cut step.obj --out a --plane y=0." + zeros + "1e2")["plane"]["offset"], 0.0);
    EXPECT_EQ(kerf_json("cut step.obj --out a --plane y=25" + zeros + "e-402")["plane"]["offset"], 0.25);
    for (const std::string plane : {"--plane y=1e400", "--plane=-y=-1e400", "--normal 0,1,0 --point 0,0,1e400",
                                    "--normal 1e400,1,0", "--normal 1,1e-400,-1e999"}) {
        const Outcome outcome = kerf("cut step.obj --out a " + plane);
        EXPECT_EQ(outcome.status, 2) << plane;
        EXPECT_NE(outcome.err.find("too large"), std::string::npos) << outcome.err;
    }
}

TEST_F(KerfCut, CutsWithTheHalfEdgeBackEndUnlessToldOtherwise)
{
    make("spiral_wall", 400);
    const std::string plane = "cut in.ply --normal 0,1,0 --out a";
    if (kerf(plane + " --backend halfedge").status == 2) GTEST_SKIP() << "this program has no half-edge back end";
    const Json cut = kerf_json(plane);
    EXPECT_EQ(cut["backend"], "halfedge");
    EXPECT_EQ(cut["warnings"], Json::array());
    EXPECT_NEAR(cut["positive"]["cap_area"].get<double>(), cut["section_area"].get<double>(), 1e-6);
    EXPECT_EQ(kerf_json(plane + " --backend baseline")["backend"], "baseline/hash");
    // Who asks for a lookup asks for the back end that has it.
    EXPECT_EQ(kerf_json(plane + " --lookup remap")["backend"], "baseline/remap");
}

TEST_F(KerfCut, TakesTheNamesOfBackEndsThatItPrints)
{
    make("box", 12);
    const std::string plane = "cut in.ply --normal 0,1,0 --out a --backend ";
    for (const std::string lookup : {"hash", "remap", "two_bucket_hash", "scan"})
        EXPECT_EQ(kerf_json(plane + "baseline/" + lookup)["backend"], "baseline/" + lookup);
    EXPECT_EQ(kerf_json(plane + "baseline/scan --lookup scan")["backend"], "baseline/scan");
    for (const char* wrong : {"baseline/", "baseline/guess", "linear/hash", "/hash", "baseline/scan --lookup hash"})
        EXPECT_EQ(kerf(plane + wrong).status, 2) << wrong;
}

TEST_F(KerfCut, SaysWhichBackEndHasWhichLookupsWhenOneIsNotThere)
{
    make("box", 12);
    const std::string plane = "cut in.ply --normal 0,1,0 --out a";
    const std::string lookups = "hash, remap, two_bucket_hash, scan\n";
    // Nobody asked for the back end that cuts by default: that it has no lookups is no help.
    for (const std::string backend : {"", " --backend baseline"}) {
        const Outcome outcome = kerf(plane + backend + " --lookup guess");
        EXPECT_EQ(outcome.status, 2);
        EXPECT_NE(outcome.err.find("the back end baseline has no lookup called 'guess': it is one of " + lookups),
                  std::string::npos)
            << outcome.err;
    }
    EXPECT_TRUE(written().empty());
    if (kerf(plane + " --backend halfedge").status == 2) GTEST_SKIP() << "this program has no half-edge back end";
    for (const std::string lookup : {"guess", "remap"}) {
        const Outcome outcome = kerf(plane + " --backend halfedge --lookup " + lookup);
        EXPECT_EQ(outcome.status, 2);
        EXPECT_NE(outcome.err.find("the back end halfedge has no lookup called '" + lookup +
                                   "': only the back end baseline has lookups, " + lookups),
                  std::string::npos)
            << outcome.err;
    }
}

TEST_F(KerfCut, NeverReplacesWhatItReads)
{
    namespace fs = std::filesystem;
    make("box", 12);
    fs::create_directory(folder_ / "d");
    for (const char* name : {"x.positive.ply", "d/x.negative.ply"}) fs::copy_file(folder_ / "in.ply", folder_ / name);
    const std::string model = text_of("in.ply");
    fs::create_hard_link(folder_ / "in.ply", folder_ / "hard.positive.ply");
    fs::create_symlink("in.ply", folder_ / "link.negative.ply");
    const std::string options = " --normal 0,1,0 --format ply --out ";
    for (const char* arguments : {"x.positive.ply", "./x.positive.ply", "d/../x.positive.ply"})
        expect_unusable(kerf("cut " + std::string(arguments) + options + "x"), "it would replace what is read");
    expect_unusable(kerf("cut d/x.negative.ply" + options + "./d/x"), "it would replace what is read");
    expect_unusable(kerf("cut in.ply" + options + "hard"), "it would replace what is read");
    expect_unusable(kerf("cut in.ply" + options + "link"), "it would replace what is read");
    EXPECT_EQ(written(), (std::vector<std::string>{"d", "hard.positive.ply", "link.negative.ply", "x.positive.ply"}));
    for (const char* name : {"in.ply", "x.positive.ply", "d/x.negative.ply"}) EXPECT_EQ(text_of(name), model);

    // The material file of an output may be that of the input.
    write("y.positive.mtl", "newmtl red\nKd 1 0 0\n");
    write("in.obj", "mtllib y.positive.mtl\nusemtl red\n" + std::string(kStep));
    expect_unusable(kerf("cut in.obj --normal 0,1,0 --out y"), "y.positive.mtl: it would replace what is read");
    EXPECT_EQ(text_of("y.positive.mtl"), "newmtl red\nKd 1 0 0\n");
}

TEST_F(KerfCut, WritesWhereALinkLeads)
{
    namespace fs = std::filesystem;
    make("box", 12);
    fs::create_directory(folder_ / "d");
    fs::create_symlink("d/other.stl", folder_ / "a.positive.stl");
    kerf_json("cut in.ply --normal 0,1,0 --format stl --out a");
    EXPECT_TRUE(fs::is_symlink(folder_ / "a.positive.stl"));
    EXPECT_GT(fs::file_size(folder_ / "d/other.stl"), 84u);
    EXPECT_EQ(written(), (std::vector<std::string>{"a.negative.stl", "a.positive.stl", "d"}));
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
    kerf_json("cut in.ply --normal 1,1,0 --backend baseline --out first");
    for (const std::string lookup : {"hash", "remap", "two_bucket_hash", "scan"}) {
        const Json cut = kerf_json("cut in.ply --normal 1,1,0 --out again --lookup " + lookup);
        EXPECT_NE(cut["backend"].get<std::string>().find(lookup), std::string::npos);
        for (const std::string side : {".positive.obj", ".negative.obj"}) {
            const core::io::LoadedMesh a = core::io::read_mesh(folder_ / ("first" + side)),
                                       b = core::io::read_mesh(folder_ / ("again" + side));
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
        // A program without the half-edge back end does not know its name.
        if (backend == "halfedge" && kerf("cut bow.obj" + options).status == 2) continue;
        EXPECT_EQ(kerf_json("cut bow.obj" + options)["warnings"], Json{"caps_exceed_section"}) << backend;
        EXPECT_NE(kerf("cut bow.obj" + options).out.find("which is not the section's"), std::string::npos) << backend;
        EXPECT_EQ(kerf_json("cut bow.obj --no-cap" + options)["warnings"], Json::array()) << backend;
        EXPECT_EQ(kerf_json("cut in.ply" + options)["warnings"], Json::array()) << backend;
    }
}

TEST_F(KerfCut, ClosesByDelaunayWhereItWasBuiltWithCgal)
{
    make("torus", 4000);
    const Outcome outcome = kerf("cut in.ply --normal 0,0,1 --cap-quality delaunay --out a");
    if (outcome.status == 2) {
        EXPECT_NE(outcome.err.find("built without CGAL"), std::string::npos) << outcome.err;
        EXPECT_TRUE(written().empty());
        return;
    }
    const Json fine = kerf_json("cut in.ply --normal 0,0,1 --cap-quality delaunay --out a"),
               fast = kerf_json("cut in.ply --normal 0,0,1 --cap-quality fast --out b");
    EXPECT_EQ(fine["positive"]["closed"], true);
    EXPECT_EQ(fine["positive"]["triangles"], fast["positive"]["triangles"]);
    EXPECT_NE(text_of("a.positive.obj"), text_of("b.positive.obj"));
    // The same from the half-edge back end that always does so, by its name.
    if (kerf("cut in.ply --normal 0,0,1 --backend halfedge/cgal --out c").status == 0) {
        EXPECT_EQ(text_of("c.positive.obj"), text_of("a.positive.obj"));
    }
    EXPECT_EQ(kerf("cut in.ply --normal 0,0,1 --cap-quality best --out a").status, 2);
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
    const Outcome outcome = kerf("cut in.ply --normal 0,0,1 --point 0,0,0.01 --backend baseline --out a");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_NE(outcome.out.find("the fan does not fit"), std::string::npos) << outcome.out;
}

TEST_F(KerfCut, SaysOfAGapThatItCutsTwice)
{
    ASSERT_EQ(kerf("shape box -n 12 -o box.obj").status, 0);
    const Outcome outcome = kerf("cut box.obj --plane z=0 --gap 0.1 --out half");
    EXPECT_NE(outcome.out.find("crossing triangles in both cuts together"), std::string::npos) << outcome.out;
    EXPECT_EQ(outcome.out.find(" of 12 triangles crossing"), std::string::npos) << outcome.out;
}

}  // namespace
}  // namespace kerf::tools
