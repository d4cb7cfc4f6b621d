#include <sstream>
#include <vector>

#include "tools/program.h"

namespace kerf::tools {
namespace {

class KerfSection : public ProgramTest
{
protected:
    void make(const std::string& shape, int triangles) const
    {
        ASSERT_EQ(kerf("shape " + shape + " --triangles " + std::to_string(triangles) + " -o in.ply").status, 0);
    }
    std::string text_of(const std::string& name) const { return read_text(folder_ / name); }
};

TEST_F(KerfSection, SaysWhatAPlaneMeets)
{
    make("torus", 2000);
    const Json section = kerf_json("section in.ply");
    EXPECT_EQ(section["status"], "done");
    ASSERT_EQ(section["loops"].size(), 2u);
    double area = 0.0, length = 0.0;
    for (const Json& loop : section["loops"]) {
        EXPECT_EQ(loop["closed"], true);
        area += loop["area"].get<double>();
        length += loop["length"].get<double>();
    }
    EXPECT_NEAR(section["area"].get<double>(), area, 1e-9);
    EXPECT_NEAR(section["length"].get<double>(), length, 1e-9);
    EXPECT_EQ(section["files"].size(), 0u);
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"in.ply"});
}

TEST_F(KerfSection, IsThatOfACut)
{
    make("two_legs", 2000);
    const Json cut = kerf_json("cut in.ply --plane y=0.1 --out half");
    const std::string help = kerf("cut --help").out;
    for (const std::string backend : {"", "halfedge", "linear", "baseline"}) {
        if (help.find(backend) == std::string::npos) continue;  // this program was built without it
        const Json section =
            kerf_json("section in.ply --plane y=0.1" + (backend.empty() ? backend : " --backend " + backend));
        EXPECT_EQ(section["area"], cut["section_area"]);
        EXPECT_EQ(section["loops"].size(), cut["counts"]["loops"]);
    }
}

TEST_F(KerfSection, DrawsAtTrueScaleAndNotMirrored)
{
    // An L of two by two units, one high. Seen from above its notch is at the upper right.
    std::string off = "OFF\n12 20 0\n";
    const std::vector<std::string> corners{"0 0", "2 0", "2 1", "1 1", "1 2", "0 2"};
    for (const char* z : {" 0\n", " 1\n"})
        for (const std::string& corner : corners) off += corner + z;
    for (int i = 1; i < 5; ++i) {
        std::ostringstream faces;
        faces << "3 0 " << i + 1 << " " << i << "\n3 6 " << i + 6 << " " << i + 7 << "\n";
        off += faces.str();
    }
    for (int i = 0; i < 6; ++i) {
        const int next = (i + 1) % 6;
        std::ostringstream faces;
        faces << "3 " << i << " " << next << " " << next + 6 << "\n3 " << i << " " << next + 6 << " " << i + 6 << "\n";
        off += faces.str();
    }
    write("l.off", off);
    const Json section = kerf_json("section l.off --unit cm -o l.svg");
    EXPECT_NEAR(section["area"].get<double>(), 3.0, 1e-12);
    const std::string svg = text_of("l.svg");
    EXPECT_NE(svg.find("width=\"20mm\" height=\"20mm\" viewBox=\"0 -20 20 20\""), std::string::npos) << svg;
    EXPECT_NE(svg.find("10 -20"), std::string::npos);
    EXPECT_NE(svg.find("20 -10"), std::string::npos);
    EXPECT_EQ(svg.find("20 -20"), std::string::npos) << "that is the notch";
    // From below it is at the upper left.
    ASSERT_EQ(kerf("section l.off --normal=0,0,-1 -o below.svg").status, 0);
    const std::string below = text_of("below.svg");
    EXPECT_NE(below.find("viewBox=\"-2 -2 2 2\""), std::string::npos) << below;
    EXPECT_EQ(below.find("-2 -2L"), std::string::npos) << below;
    ASSERT_EQ(kerf("section l.off --unit in -o l.dxf").status, 0);
    EXPECT_NE(text_of("l.dxf").find("\n50.8\n"), std::string::npos);
}

TEST_F(KerfSection, WritesEachFormat)
{
    make("sphere_in_sphere", 2000);
    for (const std::string format : {"svg", "dxf", "obj", "json"}) {
        SCOPED_TRACE(format);
        ASSERT_EQ(kerf("section in.ply -o out." + format).status, 0);
        EXPECT_FALSE(text_of("out." + format).empty());
    }
    EXPECT_NE(text_of("out.dxf").find("HOLES"), std::string::npos);
    const Json drawing = Json::parse(text_of("out.json"));
    EXPECT_EQ(drawing["loops"][0]["points"].size(), drawing["loops"][0]["point_count"]);
    EXPECT_EQ(kerf("section in.ply -o out.png").status, 1);
}

TEST_F(KerfSection, AStackHasASectionForEachHeight)
{
    make("asteroid", 2000);
    const Json stack = kerf_json("section in.ply --heights=-0.2:0.2:0.1");
    ASSERT_EQ(stack["sections"].size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(stack["sections"][i]["height"].get<double>(), -0.2 + 0.1 * double(i), 1e-12);
        EXPECT_EQ(stack["sections"][i]["status"], "done");
    }
    EXPECT_EQ(kerf_json("section in.ply --count 7")["sections"].size(), 7u);
    ASSERT_EQ(kerf("section in.ply --count 3 --each -o layer.svg").status, 0);
    EXPECT_EQ(names_in_folder(),
              (std::vector<std::string>{"in.ply", "layer.0001.svg", "layer.0002.svg", "layer.0003.svg"}));
}

TEST_F(KerfSection, OfManyPlanesIsWorthPreparing)
{
    make("asteroid", 10'000);
    if (kerf("section in.ply --backend halfedge").status == 2) GTEST_SKIP() << "this build has one back end";
    EXPECT_EQ(kerf_json("section in.ply --count 10")["backend"], "linear");
    EXPECT_EQ(kerf_json("section in.ply --count 1000")["backend"], "halfedge");
    EXPECT_EQ(kerf_json("section in.ply --heights 50:60:0.1")["backend"], "linear") << "all of them miss";
}

TEST_F(KerfSection, ThatMissesWritesNothing)
{
    make("asteroid", 500);
    const Outcome run = kerf("section in.ply --height 50 -o out.svg");
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out.find("missed"), std::string::npos);
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"in.ply"});
    EXPECT_EQ(kerf_json("section in.ply --height 50")["status"], "missed");
}

TEST_F(KerfSection, ReadsTheStandardInput)
{
    make("asteroid", 500);
    EXPECT_EQ(kerf("section - --from ply --json < in.ply").status, 0);
    EXPECT_EQ(kerf("section - < in.ply").status, 2);
}

TEST_F(KerfSection, SaysWhatIsWrongWithItsUse)
{
    make("asteroid", 500);
    for (const char* use :
         {"section", "section in.ply --normal 0,0,0", "section in.ply --heights 0:1", "section in.ply --heights 0:1:-1",
          "section in.ply --heights 0:1:1e-9", "section in.ply --height x", "section in.ply --height 1,2",
          "section in.ply --point 0,0,0 --height 1", "section in.ply --plane x=0 --normal 1,0,0",
          "section in.ply --up 0,0,0", "section in.ply --up 0,0,-2", "section in.ply --plane x=0 --up 1,0,0",
          "section in.ply --unit yard", "section in.ply --each", "section in.ply --count 0",
          "section in.ply -o - --json"})
        EXPECT_EQ(kerf(use).status, 2) << use;
    EXPECT_NE(kerf("section in.ply --height nan").err.find("'nan' is not a number"), std::string::npos);
}

TEST_F(KerfSection, SaysWhichFileHasNoFormatOfDrawings)
{
    make("asteroid", 500);
    expect_unusable(kerf("section in.ply -o x.foo"), "x.foo: the extension is not one of svg, dxf, obj, json");
}

TEST_F(KerfSection, DoesNotReplaceItsInput)
{
    make("asteroid", 500);
    ASSERT_EQ(kerf("convert in.ply -o in.obj").status, 0);
    const std::string before = text_of("in.obj");
    EXPECT_EQ(kerf("section in.obj -o in.obj").status, 1);
    EXPECT_EQ(text_of("in.obj"), before);
}

}  // namespace
}  // namespace kerf::tools
