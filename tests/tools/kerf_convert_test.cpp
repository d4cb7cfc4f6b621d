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

TEST_F(KerfConvert, NeverReplacesAnotherFileThatItReads)
{
    for (const char* order : {"same.obj same.ply", "same.ply same.obj"}) {
        SCOPED_TRACE(order);
        ASSERT_EQ(kerf("shape cone --triangles 100 -o same.obj").status, 0);
        ASSERT_EQ(kerf("shape box --triangles 300 -o same.ply").status, 0);
        const std::string before = text_of("same.ply");
        expect_unusable(kerf("convert " + std::string(order) + " --to ply"), "it would replace what is read");
        EXPECT_EQ(text_of("same.ply"), before);
    }
}

TEST_F(KerfConvert, NeverWritesTwoFilesToOnePlace)
{
    for (const char* folder : {"one", "two", "out"}) std::filesystem::create_directory(folder_ / folder);
    ASSERT_EQ(kerf("shape cone --triangles 100 -o one/part.obj").status, 0);
    ASSERT_EQ(kerf("shape box --triangles 300 -o two/part.obj").status, 0);
    expect_unusable(kerf("convert one/part.obj two/part.obj --to ply --folder out"), "another file of the same call");
    EXPECT_TRUE(std::filesystem::is_empty(folder_ / "out"));
}

TEST_F(KerfConvert, WritesAllOrNothing)
{
    ASSERT_EQ(kerf("shape cone --triangles 100 -o good.obj").status, 0);
    write("bad.obj", "this is no mesh\n");
    const Outcome outcome = kerf("convert good.obj bad.obj --to ply");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "good.ply"));
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
