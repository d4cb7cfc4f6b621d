#include <sstream>

#include "tools/program.h"

namespace kerf::tools {
namespace {

using KerfShape = ProgramTest;

TEST_F(KerfShape, WritesEveryShapeThatItsHelpNames)
{
    const std::string help = kerf("shape --help").out;
    const std::size_t first = help.find("Shapes: ") + 8;
    std::string names = help.substr(first, help.find('.', first) - first);
    for (char& c : names)
        if (c == ',') c = ' ';
    std::istringstream in(names);
    std::size_t count = 0;
    for (std::string name; in >> name; ++count) {
        SCOPED_TRACE(name);
        const Outcome outcome = kerf("shape " + name + " --triangles 2000 -o " + name + ".ply");
        ASSERT_EQ(outcome.status, 0) << outcome.err;
        const Json info = kerf_json("info " + name + ".ply");
        EXPECT_EQ(info["closed"], true);
        EXPECT_EQ(info["manifold"], true);
        EXPECT_EQ(info["oriented"], true);
        EXPECT_GT(info["volume"], 0.0);
    }
    EXPECT_GE(count, 10u);
}

TEST_F(KerfShape, MakesAboutAsManyTrianglesAsAskedFor)
{
    kerf("shape asteroid --triangles 20000 -o a.ply");
    const std::uint64_t triangles = kerf_json("info a.ply")["triangles"];
    EXPECT_NEAR(static_cast<double>(triangles), 20000.0, 1000.0);
}

TEST_F(KerfShape, GivesTheSameBytesForTheSameSeedOnly)
{
    for (const char* format : {"obj", "ply", "stl", "off", "glb"}) {
        const std::string end = " --triangles 500 -o ";
        kerf("shape asteroid --seed 1" + end + "a." + format);
        kerf("shape asteroid --seed 1" + end + "b." + format);
        kerf("shape asteroid --seed 2" + end + "c." + format);
        const std::string a = text_of(std::string("a.") + format);
        EXPECT_FALSE(a.empty());
        EXPECT_EQ(a, text_of(std::string("b.") + format));
        EXPECT_NE(a, text_of(std::string("c.") + format));
    }
}

TEST_F(KerfShape, ReadsWholeNumbersAsDecimal)
{
    for (const char* seed : {"10", "010", "+10"})
        EXPECT_EQ(kerf("shape asteroid --triangles 500 --seed " + std::string(seed) + " -o " + seed + ".ply").status,
                  0);
    EXPECT_EQ(text_of("010.ply"), text_of("10.ply"));
    EXPECT_EQ(text_of("+10.ply"), text_of("10.ply"));
    for (const char* seed : {"0x10", "1e3", "+-1", "++1", "18446744073709551616"}) {
        const Outcome outcome = kerf("shape asteroid -o a.ply --seed " + std::string(seed));
        EXPECT_EQ(outcome.status, 2) << seed;
        EXPECT_NE(outcome.err.find("is no whole number from 0 to"), std::string::npos) << outcome.err;
    }
}

TEST_F(KerfShape, RefusesPlacesThatItCannotWriteTo)
{
    expect_unusable(kerf("shape box -o gone/a.obj"), "gone/a.obj: it cannot be written");
    std::filesystem::create_symlink("nowhere/a.obj", folder_ / "link.obj");
    expect_unusable(kerf("shape box -o link.obj"),
                    "link.obj: it cannot be written: the link of this name leads into a");
    std::filesystem::remove(folder_ / "link.obj");
    expect_unusable(kerf("shape box -o a.gltf"), "a.gltf: the extension");
    EXPECT_TRUE(names_in_folder().empty());
}

}  // namespace
}  // namespace kerf::tools
