#include <algorithm>
#include <cmath>

#include "tools/program.h"

namespace kerf::tools {
namespace {

class KerfCompare : public ProgramTest
{
protected:
    static std::string models() { return std::string("'") + KERF_DATA_DIR + "'/models/"; }

    void SetUp() override
    {
        write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
        if (kerf("compare a.obj --planes 1").err.find("without the half-edge back end") != std::string::npos)
            GTEST_SKIP() << "this program has no half-edge back end";
    }

    void make(const std::string& shape, int triangles) const
    {
        ASSERT_EQ(kerf("shape " + shape + " --triangles " + std::to_string(triangles) + " -o in.ply").status, 0);
    }

    /// A result in which everything is as it must be.
    static void expect_agreement(const Json& result)
    {
        const Json& total = result["total"];
        EXPECT_EQ(total["failed"], 0);
        EXPECT_EQ(total["surfaces_differ"], 0);
        EXPECT_EQ(total["pieces_differ"], 0);
        EXPECT_EQ(total["caps_wrong"], 0);
        EXPECT_EQ(total["equal_corners"], Json({{"baseline", 0}, {"halfedge", 0}}));
        for (const Json& file : result["files"]) {
            EXPECT_TRUE(file["failures"].empty());
            if (file["closed"] == true) {
                EXPECT_EQ(file["summary"]["open_edges"], Json({{"baseline", 0}, {"halfedge", 0}}));
            }
        }
        EXPECT_LE(total["volume_error"]["halfedge"].get<double>(), 1e-6);
    }
};

TEST_F(KerfCompare, FindsThatTheBackEndsAgreeOnTheReportsModels)
{
    const Json result = kerf_json("compare " + models() + "*.obj");
    EXPECT_EQ(result["files"].size(), 15u);
    for (const Json& file : result["files"]) {
        EXPECT_EQ(file["rows"].size(), 20u);
        EXPECT_EQ(file["closed"], true);
        EXPECT_GT(file["summary"]["cut"], 8);
    }
    EXPECT_GT(result["total"]["fans_wrong"], 50);
    expect_agreement(result);
}

TEST_F(KerfCompare, FindsThatCapsOfCgalHaveTheSameAreas)
{
    make("menger_sponge", 4000);
    if (kerf("compare in.ply --planes 1 --with halfedge/cgal").status == 2) GTEST_SKIP() << "built without CGAL";
    expect_agreement(kerf_json("compare in.ply --planes 10 --with halfedge/cgal"));
}

TEST_F(KerfCompare, GivesTheTrianglesOfBothCapsOnRequest)
{
    // A plane through a torus's middle cuts it in two rings or two discs: a fan over both covers what is between.
    make("torus", 800);
    const Json row = kerf_json("compare in.ply --caps --planes 1 --random-only")["files"][0]["rows"][0];
    const auto area = [](const Json& cap) {
        double twice = 0.0;
        for (const Json& t : cap["triangles"]) {
            const auto corner = [&](std::size_t i) { return cap["points"][t[i].get<std::size_t>()]; };
            const auto x = [&](std::size_t i) { return corner(i)[0].get<double>() - corner(0)[0].get<double>(); };
            const auto y = [&](std::size_t i) { return corner(i)[1].get<double>() - corner(0)[1].get<double>(); };
            twice += std::abs(x(1) * y(2) - y(1) * x(2));
        }
        return twice / 2;
    };
    const double section = row["section_area"].get<double>();
    EXPECT_NEAR(area(row["caps"]["halfedge"]), section, 1e-6 * section);
    EXPECT_NEAR(area(row["caps"]["baseline"]), section + row["baseline"]["cap_excess"].get<double>(), 1e-6 * section);
    EXPECT_GT(row["baseline"]["cap_overlap"].get<double>(), 0.01 * section);
    EXPECT_EQ(row["caps"]["loops"].size(), row["loops"].get<std::size_t>());
    EXPECT_FALSE(kerf_json("compare in.ply --planes 1")["files"][0]["rows"][0].contains("caps"));
    EXPECT_EQ(kerf("compare in.ply --caps").status, 2);
}

TEST_F(KerfCompare, CutsThePiecesAgain)
{
    make("torus", 800);
    const Json result = kerf_json("compare in.ply --planes 6 --depth 4");
    expect_agreement(result);
    std::size_t deepest = 0, deep_cuts = 0;
    for (const Json& row : result["files"][0]["rows"]) {
        const std::size_t depth = row["piece"].get<std::string>().size();
        deepest = std::max(deepest, depth);
        if (depth == 3 && row["status"] == "cut") ++deep_cuts;
    }
    EXPECT_EQ(deepest, 3u);
    EXPECT_GT(deep_cuts, 30u);
}

TEST_F(KerfCompare, AgreesOnEveryShape)
{
    for (const std::string shape :
         {"box", "comb", "cone", "icosphere", "l_step", "menger_sponge", "pipe", "sphere_in_sphere", "spiral_wall"}) {
        make(shape, 500);
        const Outcome outcome = kerf("compare in.ply --planes 16 --depth 2 --seed 5");
        EXPECT_EQ(outcome.status, 0) << shape << "\n" << outcome.out << outcome.err;
        EXPECT_NE(outcome.out.find("surfaces equal bit for bit"), std::string::npos) << shape;
    }
}

TEST_F(KerfCompare, MeasuresTheFanAgainstTheSection)
{
    make("torus", 5000);
    // The third plane of the sequence is across the axis: a ring.
    const Json row = kerf_json("compare in.ply --only 2")["files"][0]["rows"][0];
    EXPECT_EQ(row["number"], 2);
    EXPECT_EQ(row["loops"], 2);
    EXPECT_EQ(row["fan_fits"], false);
    EXPECT_EQ(row["cap_fits"], true);
    const double area = row["section_area"], fan = row["baseline"]["cap_area"]["positive"];
    EXPECT_NEAR(row["baseline"]["cap_excess"].get<double>(), fan - area, 1e-12);
    EXPECT_GT(fan, 1.1 * area);
    EXPECT_NEAR(row["halfedge"]["cap_area"]["negative"].get<double>(), area, 1e-6 * area);
}

TEST_F(KerfCompare, TakesPlanesFromTheSeed)
{
    make("asteroid", 500);
    const auto offsets = [&](const std::string& options) {
        Json list = Json::array();
        const Json result = kerf_json("compare in.ply --planes 10 " + options);
        for (const Json& row : result["files"][0]["rows"]) list.push_back(row["plane"]["offset"]);
        return list;
    };
    EXPECT_EQ(offsets("--seed 4"), offsets("--seed 4 --lookup remap"));
    EXPECT_NE(offsets("--seed 4"), offsets("--seed 5"));
    const Json random = kerf_json("compare in.ply --planes 10 --random-only");
    EXPECT_EQ(random["files"][0]["rows"].size(), 10u);
    for (const Json& row : random["files"][0]["rows"]) EXPECT_EQ(row["kind"], "random");
    EXPECT_EQ(kerf_json("compare in.ply --only 7 --seed 4")["files"][0]["rows"][0]["plane"]["offset"],
              offsets("--seed 4")[7]);
}

TEST_F(KerfCompare, AcceptsOpenMeshes)
{
    write("sheet.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.5\nf 1 2 3 4\n");
    const Json result = kerf_json("compare sheet.obj --planes 40");
    EXPECT_EQ(result["files"][0]["closed"], false);
    EXPECT_GT(result["total"]["cut"], 5);
    EXPECT_EQ(result["total"]["surfaces_differ"], 0);
    EXPECT_EQ(result["total"]["pieces_differ"], 0);
}

TEST_F(KerfCompare, RefusesFilesThatCannotBeUsedInOneLine)
{
    write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    expect_unusable(kerf("compare broken.obj"), "broken.obj: line 4");
    expect_unusable(kerf("compare none.ply --json"), "none.ply: there is no such file");
}

TEST_F(KerfCompare, OneUnusableFileOfManyIsARowAndTheOthersAreCompared)
{
    write("broken.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
    const Outcome json = kerf("compare a.obj broken.obj none.ply a.obj --planes 5 --json");
    EXPECT_EQ(json.status, 1);
    EXPECT_EQ(json.error_lines(), 1) << json.err;
    EXPECT_NE(json.err.find("2 of 4 files could not be compared"), std::string::npos) << json.err;
    const Json result = Json::parse(json.out, nullptr, false);
    ASSERT_FALSE(result.is_discarded());
    ASSERT_EQ(result["files"].size(), 4u);
    EXPECT_EQ(result["unusable_files"], 2);
    EXPECT_NE(result["files"][1]["error"].get<std::string>().find("broken.obj: line 4"), std::string::npos);
    EXPECT_NE(result["files"][2]["error"].get<std::string>().find("none.ply: there is no such file"),
              std::string::npos);
    EXPECT_EQ(result["files"][3]["rows"].size(), 5u);
    EXPECT_EQ(result["total"]["rows"], 10);

    const Outcome text = kerf("compare broken.obj a.obj --planes 5 --quiet");
    EXPECT_EQ(text.status, 1);
    EXPECT_EQ(text.error_lines(), 1) << text.err;
    EXPECT_NE(text.out.find("NOT COMPARED: broken.obj: line 4"), std::string::npos) << text.out;
    EXPECT_NE(text.out.find("all 2 files, 1 of them NOT COMPARED: "), std::string::npos) << text.out;
}

TEST_F(KerfCompare, ComparesThePlaneOfAnyNumberAlone)
{
    for (const char* number : {"0", "77", "18446744073709551614", "18446744073709551615"}) {
        const Json result = kerf_json(std::string("compare a.obj --only ") + number);
        ASSERT_EQ(result["total"]["rows"], 1) << number;
        EXPECT_EQ(result["files"][0]["rows"][0]["number"], std::stoull(number));
    }
}

TEST_F(KerfCompare, AResultThatCannotBePrintedEndsIt)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
    const Outcome outcome = kerf("compare a.obj a.obj > /dev/full");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.err, "kerf: the result cannot be written to standard output\n");
}

TEST_F(KerfCompare, WrongUseExitsWith2)
{
    for (const char* arguments : {"compare", "compare a.obj --planes 0", "compare a.obj --planes many",
                                  "compare a.obj --depth 0", "compare a.obj --depth 99", "compare a.obj --seed x",
                                  "compare a.obj --lookup guess", "compare a.obj --colour"}) {
        const Outcome outcome = kerf(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_NE(outcome.err.find("Usage: kerf"), std::string::npos) << arguments << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "") << arguments;
    }
    EXPECT_EQ(kerf("compare --help").status, 0);
}

TEST_F(KerfCompare, TheHalfEdgeBackEndCanBeChosenForCutting)
{
    make("torus", 2000);
    const std::string plane = "cut in.ply --normal 0,0,1 --point 0,0,0.01 --backend halfedge --out h";
    const Json cut = kerf_json(plane);
    EXPECT_EQ(cut["backend"], "halfedge");
    EXPECT_EQ(cut["counts"]["loops"], 2);
    for (const char* side : {"positive", "negative"}) {
        EXPECT_EQ(cut[side]["closed"], true);
        EXPECT_NEAR(cut[side]["cap_area"].get<double>(), cut["section_area"].get<double>(), 1e-6);
    }
    EXPECT_EQ(kerf(plane).out.find("the fan does not fit"), std::string::npos);
    EXPECT_EQ(kerf_json(plane + " --no-cap")["positive"]["closed"], false);

    make("comb", 100);
    const Json parts = kerf_json("cut in.ply --normal 0,1,0 --backend halfedge --components --out p");
    const Json same = kerf_json("cut in.ply --normal 0,1,0 --backend baseline --components --out q");
    EXPECT_EQ(parts["positive"]["pieces"].size(), same["positive"]["pieces"].size());
    EXPECT_EQ(parts["negative"]["pieces"].size(), same["negative"]["pieces"].size());
    EXPECT_EQ(kerf("cut in.ply --normal 0,1,0 --backend halfedge --lookup hash --out p").status, 2);
}

TEST_F(KerfCompare, FindsThatTheLinearBackEndClosesAsTheHalfEdgeOneDoes)
{
    for (const char* shape : {"menger_sponge", "spiral_wall", "nested_spheres", "overlapping_spheres", "comb"}) {
        ASSERT_EQ(kerf("shape " + std::string(shape) + " --triangles 600 -o a.ply").status, 0);
        const Outcome outcome = kerf("compare a.ply --with linear --planes 25 --depth 2 --quiet");
        EXPECT_EQ(outcome.status, 0) << shape << ": " << outcome.out << outcome.err;
        EXPECT_EQ(outcome.out.find("fan wrong"), std::string::npos) << outcome.out;
    }
    EXPECT_EQ(kerf("compare a.ply --with baseline/remap --planes 5").status, 0);
    EXPECT_EQ(kerf("compare a.ply --with linear --lookup hash").status, 2);
    EXPECT_EQ(kerf("compare a.ply --with halfedge").status, 2);
}

}  // namespace
}  // namespace kerf::tools
