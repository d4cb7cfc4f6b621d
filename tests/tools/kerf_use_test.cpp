#include "tools/program.h"

namespace kerf::tools {
namespace {

using KerfUse = ProgramTest;

TEST_F(KerfUse, WrongUseExitsWith2AndShowsUsage)
{
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    for (const char* arguments : {"",
                                  "saw",
                                  "info",
                                  "info --colour a.obj",
                                  "info a.obj b.obj --json",
                                  "info a.obj -j many",
                                  "info a.obj -j -1",
                                  "info a.obj -j 1025",
                                  "cut",
                                  "cut a.obj",
                                  "cut a.obj --out b",
                                  "cut a.obj --normal 0,0,1",
                                  "cut a.obj --normal 0,0 --out b",
                                  "cut a.obj --normal 0,0,1,2 --out b",
                                  "cut a.obj --normal 0,0,x --out b",
                                  "cut a.obj --normal 0,0,nan --out b",
                                  "cut a.obj --normal 0,0,0 --out b",
                                  "cut a.obj --normal 1,0,0 --point 1,2 --out b",
                                  "cut a.obj --normal 1,0,0 --out b --format gltf",
                                  "cut a.obj --normal 1,0,0 --out b --backend saw",
                                  "cut a.obj --normal 1,0,0 --out b --lookup guess",
                                  "shape",
                                  "shape box",
                                  "shape teapot -o a.obj",
                                  "shape box --triangles 0 -o b.obj",
                                  "shape box --triangles -5 -o b.obj",
                                  "shape box --triangles many -o b.obj",
                                  "shape box --triangles 16000001 -o b.obj",
                                  "shape box --seed 18446744073709551616 -o b.obj",
                                  "shape box --seed ' -1' -o b.obj",
                                  "shape box --seed 0x10000000000000000 -o b.obj",
                                  "compare a.obj --seed 99999999999999999999999",
                                  "compare a.obj --only 18446744073709551616",
                                  "compare a.obj --only -1"}) {
        const Outcome outcome = kerf(arguments);
        EXPECT_EQ(outcome.status, 2) << arguments;
        EXPECT_NE(outcome.err.find("Usage: kerf"), std::string::npos) << arguments << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "") << arguments;
    }
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.obj"});
}

TEST_F(KerfUse, HelpIsNoErrorAndHasExamples)
{
    EXPECT_EQ(kerf("--help").status, 0);
    EXPECT_EQ(kerf("--version").status, 0);
    for (const std::string command : {"info", "cut", "shape", "compare"}) {
        const Outcome outcome = kerf(command + " --help");
        EXPECT_EQ(outcome.status, 0);
        EXPECT_NE(outcome.out.find("Examples:"), std::string::npos) << command;
    }
}

TEST_F(KerfUse, AResultThatCannotBePrintedIsAnError)
{
    if (!std::filesystem::exists("/dev/full")) GTEST_SKIP();
    write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    EXPECT_EQ(kerf("info a.obj > /dev/full").status, 1);
}

}  // namespace
}  // namespace kerf::tools
