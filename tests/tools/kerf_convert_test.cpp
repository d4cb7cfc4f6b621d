#include <filesystem>

#include "tools/program.h"

namespace kerf::tools {
namespace {

using KerfConvert = ProgramTest;

TEST_F(KerfConvert, GivesTheSameTrianglesInEveryFormat)
{
    ASSERT_EQ(kerf("shape torus --triangles 500 -o a.ply").status, 0);
    const Json before = kerf_json("info a.ply");
    for (const char* format : {"obj", "stl", "off", "glb", "ply"}) {
        SCOPED_TRACE(format);
        const std::string out = std::string("b.") + format;
        ASSERT_EQ(kerf("convert a.ply -o " + out).status, 0);
        const Json after = kerf_json("info " + out);
        for (const char* fact : {"triangles", "welded_vertices", "closed", "area", "volume", "bounds"})
            EXPECT_EQ(after[fact], before[fact]) << fact;
    }
}

TEST_F(KerfConvert, TakesSeveralFilesBesideWhatIsReadOrIntoAFolder)
{
    std::filesystem::create_directory(folder_ / "in");
    std::filesystem::create_directory(folder_ / "out");
    ASSERT_EQ(kerf("shape cone --triangles 100 -o in/one.obj").status, 0);
    ASSERT_EQ(kerf("shape box --triangles 100 -o in/two.stl").status, 0);
    EXPECT_EQ(kerf("convert in/one.obj in/two.stl --to off").status, 0);
    EXPECT_EQ(kerf("convert in/one.obj in/two.stl --to glb --folder out").status, 0);
    for (const char* name : {"in/one.off", "in/two.off", "out/one.glb", "out/two.glb"})
        EXPECT_TRUE(std::filesystem::exists(folder_ / name)) << name;
}

TEST_F(KerfConvert, SaysIfAMeshHadToBeRepaired)
{
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
    EXPECT_NE(kerf("convert a.obj -o b.ply").out.find("; repaired: "), std::string::npos);
    EXPECT_EQ(kerf("convert b.ply -o c.ply").out.find("repaired"), std::string::npos);
}

TEST_F(KerfConvert, WantsOneWayToNameWhatIsWritten)
{
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const char* wrong : {"a.obj", "a.obj -o b.ply --to ply", "a.obj a.obj -o b.ply", "a.obj --to bmp",
                              "a.obj -o b.ply --folder x", "--to ply"}) {
        const Outcome outcome = kerf("convert " + std::string(wrong));
        EXPECT_EQ(outcome.status, 2) << wrong;
        EXPECT_EQ(outcome.out, "") << wrong;
    }
    expect_unusable(kerf("convert a.obj --to obj"), "it would replace what is read");
}

}  // namespace
}  // namespace kerf::tools
