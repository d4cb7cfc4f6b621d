#include <sstream>

#include "tools/program.h"

namespace kerf::tools {
namespace {

/// The standard streams, and many files at once.
using KerfStreams = ProgramTest;

TEST_F(KerfStreams, EveryCommandThatReadsOneMeshReadsTheStandardInput)
{
    ASSERT_EQ(kerf("shape box -o box.stl").status, 0);
    const std::string pipe = "cat box.stl |";
    EXPECT_EQ(kerf("info - --format stl", pipe).out, kerf("info - --from stl < box.stl").out);
    EXPECT_EQ(kerf("cut - --from stl --plane z=0 --out a", pipe).status, 0);
    EXPECT_EQ(kerf("cut box.stl --plane z=0 --out b").status, 0);
    EXPECT_EQ(read_text(folder_ / "a.positive.obj"), read_text(folder_ / "b.positive.obj"));
    EXPECT_EQ(kerf("repair - --from stl -o r.ply", pipe).status, 0);
    EXPECT_EQ(kerf("convert - --from stl -o c.ply", pipe).status, 0);
    EXPECT_EQ(read_text(folder_ / "r.ply"), read_text(folder_ / "c.ply"));
    EXPECT_EQ(kerf("dice - --from stl --grid 2x1x1 --out d", pipe).status, 0);
    EXPECT_EQ(kerf("section - --from stl -o s.svg", pipe).status, 0);
}

TEST_F(KerfStreams, OneMeshGoesToTheStandardOutput)
{
    ASSERT_EQ(kerf("shape box -o box.stl").status, 0);
    ASSERT_EQ(kerf("convert box.stl -o box.ply").status, 0);
    EXPECT_EQ(kerf("convert - -o - --from stl --format ply < box.stl").out, read_text(folder_ / "box.ply"));
    EXPECT_EQ(kerf("repair - -o - --from stl --format ply < box.stl").out, read_text(folder_ / "box.ply"));
    ASSERT_EQ(kerf("cut box.stl --plane z=0 --format stl --out half").status, 0);
    EXPECT_EQ(kerf("cut - --format stl --plane z=0 --keep negative --out - < box.stl").out,
              read_text(folder_ / "half.negative.stl"));
    const Outcome piped = kerf("info - --format stl --json",
                               "'" KERF_PROGRAM "' cut box.stl --plane z=0 --keep positive --out - --format stl |");
    EXPECT_NEAR(Json::parse(piped.out)["volume"].get<double>(), 0.5, 1e-6);
}

TEST_F(KerfStreams, KeepWritesOneSide)
{
    ASSERT_EQ(kerf("shape box -o box.stl").status, 0);
    ASSERT_EQ(kerf("cut box.stl --plane z=0 --keep positive --out half").status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "half.positive.obj"));
    EXPECT_FALSE(std::filesystem::exists(folder_ / "half.negative.obj"));
}

TEST_F(KerfStreams, WhatAStreamCanNotHoldIsWrongUse)
{
    ASSERT_EQ(kerf("shape box -o box.stl").status, 0);
    for (const char* command :
         {"info -", "info - - --format stl", "info box.stl box.stl --json", "cut - --plane z=0 --out a",
          "cut box.stl --plane z=0 --out -", "cut box.stl --plane z=0 --keep positive --out - --json",
          "cut box.stl --plane z=0 --keep positive --out - --components", "cut - --from stl --batch - --out a",
          "cut box.stl --plane z=0 --results r --out a", "repair - -o a.ply", "repair box.stl -o -",
          "convert box.stl -o -", "convert - --from stl --to ply", "convert -o a.ply"}) {
        const Outcome outcome = kerf(std::string(command) + " < box.stl");
        EXPECT_EQ(outcome.status, 2) << command << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "") << command;
    }
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"box.stl"});
}

TEST_F(KerfStreams, ManyFilesAreALineEachInTheirOrder)
{
    std::string files;
    for (int i = 0; i < 30; ++i) {
        const std::string name = std::to_string(i) + ".ply";
        ASSERT_EQ(kerf("shape asteroid -n " + std::to_string(3000 - 90 * i) + " -o " + name).status, 0);
        files += " " + name + (i == 7 ? " nowhere.ply" : "");
    }
    const Outcome one = kerf("info --jsonl" + files);
    const Outcome four = kerf("info --jsonl -j 4" + files);
    EXPECT_EQ(one.status, 1);
    EXPECT_EQ(one.err, "kerf: 1 of 31 files can't be used\n");
    EXPECT_EQ(one.out, four.out);
    std::istringstream lines(one.out);
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        const Json json = Json::parse(line);
        if (count == 8)
            EXPECT_NE(json["error"].get<std::string>().find("nowhere.ply"), std::string::npos);
        else
            EXPECT_EQ(json["closed"], true) << line;
    }
    EXPECT_EQ(count, 31);
    EXPECT_EQ(kerf("info --jsonl 1.ply").status, 0);
    const Outcome text = kerf("info 0.ply nowhere.ply 1.ply -j 0");
    EXPECT_EQ(text.status, 1);
    EXPECT_NE(text.out.find("1.ply\n"), std::string::npos);
    EXPECT_EQ(text.error_lines(), 2) << text.err;
    std::filesystem::create_directory(folder_ / "stl");
    EXPECT_EQ(kerf("convert 0.ply 1.ply 2.ply 3.ply --to stl --folder stl -j 3").status, 0);
    EXPECT_TRUE(std::filesystem::exists(folder_ / "stl/3.stl"));
}

/// What bash would offer behind `line`, a word a line.
class KerfCompletion : public ProgramTest
{
protected:
    std::string offered(const std::string& line) const
    {
        write("complete.sh", "cd '" + folder_.string() +
                                 "'; source <('" KERF_PROGRAM "' completion bash); COMP_WORDS=(" + line + "); [[ '" +
                                 line +
                                 "' == *' ' ]] && COMP_WORDS+=(''); COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _kerf "
                                 "2>/dev/null; printf '%s\\n' \"${COMPREPLY[@]}\" | sort | tr '\\n' ' '\n");
        return kerf("--version > version; bash complete.sh").out;
    }
};

TEST_F(KerfCompletion, OffersCommandsOptionsChoicesAndMeshes)
{
    write("a b.stl", "");
    write("rook.obj", "");
    write("notes.txt", "");
    std::filesystem::create_directory(folder_ / "parts");
    EXPECT_EQ(offered("kerf co"), "compare completion convert ");
    EXPECT_EQ(offered("kerf cut --thr"), "--through ");
    EXPECT_EQ(offered("kerf cut --keep p"), "positive ");
    EXPECT_EQ(offered("kerf cut --format "), "glb obj off ply stl ");
    EXPECT_EQ(offered("kerf cut --format = p"), "ply ");
    EXPECT_EQ(offered("kerf section --format d"), "dxf ");
    EXPECT_EQ(offered("kerf cut --plane "), " ");
    EXPECT_EQ(offered("kerf shape asteroi"), "asteroid ");
    EXPECT_EQ(offered("kerf bogus "), " ");
    EXPECT_EQ(offered("kerf info "), "a b.stl parts rook.obj ");
    EXPECT_EQ(kerf("completion fish").status, 2);
}

}  // namespace
}  // namespace kerf::tools
