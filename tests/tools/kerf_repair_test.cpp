#include "tools/program.h"

namespace kerf::tools {
namespace {

using KerfRepair = ProgramTest;

/// A tetrahedron with one triangle turned over, one given twice, and one without an area.
constexpr const char* kBroken =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 4 3\nf 3 1 4\nf 1 3 2\nf 1 1 2\n";

TEST_F(KerfRepair, WritesAMeshThatNeedsNoRepair)
{
    write("a.obj", kBroken);
    EXPECT_EQ(kerf_json("info a.obj")["oriented"], false);
    const Json said = kerf_json("repair a.obj -o b.ply");
    EXPECT_EQ(said["triangles_before"], 6);
    EXPECT_EQ(said["triangles"], 4);
    EXPECT_EQ(said["closed"], true);
    EXPECT_EQ(said["repairs"]["flipped_triangles"], 1);
    EXPECT_EQ(said["repairs"]["duplicate_triangles"], 1);
    EXPECT_EQ(said["repairs"]["degenerate_triangles"], 1);
    const Json info = kerf_json("info b.ply");
    EXPECT_EQ(info["triangles"], 4);
    EXPECT_EQ(info["closed"], true);
    EXPECT_EQ(info["oriented"], true);
    EXPECT_EQ(info["repairs"]["text"], "");
    EXPECT_NEAR(info["volume"].get<double>(), 1.0 / 6.0, 1e-7);
}

TEST_F(KerfRepair, SaysInALineWhatItHasDone)
{
    write("a.obj", kBroken);
    const Outcome outcome = kerf("repair a.obj -o b.off");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("b.off: 4 triangles, closed; "), std::string::npos) << outcome.out;
    EXPECT_NE(kerf("repair b.off -o c.stl").out.find("nothing had to be repaired"), std::string::npos);
}

TEST_F(KerfRepair, FillsNoHole)
{
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Json said = kerf_json("repair a.obj -o b.ply");
    EXPECT_EQ(said["closed"], false);
    EXPECT_EQ(said["triangles"], 1);
}

TEST_F(KerfRepair, ReplacesNothingThatItReads)
{
    write("a.obj", kBroken);
    expect_unusable(kerf("repair a.obj -o a.obj"), "it would replace what is read");
    EXPECT_EQ(text_of("a.obj"), kBroken);
}

TEST_F(KerfRepair, RefusesAFormatThatItDoesNotWrite)
{
    write("a.obj", kBroken);
    expect_unusable(kerf("repair a.obj -o b.gltf"), "choose one of these");
    EXPECT_EQ(kerf("repair a.obj").status, 2);
}

}  // namespace
}  // namespace kerf::tools
