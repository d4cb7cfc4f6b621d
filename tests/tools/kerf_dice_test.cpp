#include <set>
#include <string>
#include <vector>

#include "tools/program.h"

namespace kerf::tools {
namespace {

class KerfDice : public ProgramTest
{
protected:
    void make(const std::string& shape, int triangles) const
    {
        ASSERT_EQ(kerf("shape " + shape + " --triangles " + std::to_string(triangles) + " -o in.ply").status, 0);
    }
};

TEST_F(KerfDice, WritesAFileForEachCell)
{
    make("asteroid", 1000);
    const Json whole = kerf_json("info in.ply");
    const Json diced = kerf_json("dice in.ply --grid 2x1x3 --out piece");
    EXPECT_EQ(diced["pieces"].size(), 6u);
    EXPECT_EQ(diced["empty_cells"], 0);
    EXPECT_EQ(names_in_folder(),
              (std::vector<std::string>{"in.ply", "piece.0-0-0.obj", "piece.0-0-1.obj", "piece.0-0-2.obj",
                                        "piece.1-0-0.obj", "piece.1-0-1.obj", "piece.1-0-2.obj"}));
    double volume = 0.0;
    for (const Json& piece : diced["pieces"]) {
        EXPECT_EQ(piece["closed"], true);
        const Json read = kerf_json("info " + piece["file"].get<std::string>());
        EXPECT_EQ(read["closed"], true);
        volume += read["volume"].get<double>();
    }
    EXPECT_NEAR(volume, whole["volume"].get<double>(), 1e-5 * volume);
    EXPECT_NEAR(diced["volume"].get<double>(), whole["volume"].get<double>(), 1e-6 * volume);
}

TEST_F(KerfDice, FitsPiecesIntoASize)
{
    make("box", 12);  // of one unit
    const Json diced = kerf_json("dice in.ply --size 0.4,0,2 --gap 0.1 --format stl --out part");
    EXPECT_EQ(diced["pieces"].size(), 3u);
    EXPECT_NEAR(diced["volume"].get<double>(), 1.0 - 2 * 0.1, 1e-5);
    EXPECT_EQ(names_in_folder(),
              (std::vector<std::string>{"in.ply", "part.0-0-0.stl", "part.1-0-0.stl", "part.2-0-0.stl"}));
}

TEST_F(KerfDice, CutsByPlanesOfAFile)
{
    make("box", 12);
    write("planes.txt", "# a normal and a distance\n1 0 0 0\n\n0 1 0 0.25\n0 0 1 -0.25\n1 1 1 0.1\n");
    const Json diced = kerf_json("dice in.ply --planes planes.txt --out p");
    EXPECT_NEAR(diced["volume"].get<double>(), 1.0, 1e-5);
    EXPECT_EQ(diced["pieces"].size() + diced["empty_cells"].get<std::size_t>(), 16u);
    for (std::size_t i = 0; i < diced["pieces"].size(); ++i)
        EXPECT_EQ(diced["pieces"][i]["file"], "p." + std::to_string(i) + ".obj");
    write("layers.txt", "1 0 0 0.25\n0 1 0 0\n-2 0 0 0.25\n1 0 0 0\n");
    const Json layers = kerf_json("dice in.ply --planes layers.txt --out q");
    EXPECT_EQ(layers["pieces"].size(), 8u);
    EXPECT_EQ(layers["empty_cells"], 0) << "planes across x are layers, whichever way they look";
    write("wrong.txt", "1 0 0 0\n0 0 0 1\n");
    expect_unusable(kerf("dice in.ply --planes wrong.txt --out p"), "line 2");
    expect_unusable(kerf("dice in.ply --planes none.txt --out p"), "none.txt");
}

TEST_F(KerfDice, GivesTheSamePiecesWithEveryBackEnd)
{
    make("torus", 800);
    const Json first = kerf_json("dice in.ply --grid 3x3x3 --out a");
    for (const char* backend : {"halfedge", "linear"}) {
        if (kerf("cut --help").out.find(backend) == std::string::npos) continue;  // this program was built without it
        const Json other = kerf_json("dice in.ply --grid 3x3x3 --out b --backend " + std::string(backend));
        ASSERT_EQ(other["pieces"].size(), first["pieces"].size());
        for (std::size_t i = 0; i < other["pieces"].size(); ++i) {
            EXPECT_EQ(other["pieces"][i]["cell"], first["pieces"][i]["cell"]);
            EXPECT_NEAR(other["pieces"][i]["volume"].get<double>(), first["pieces"][i]["volume"].get<double>(), 1e-6);
        }
    }
}

TEST_F(KerfDice, DividesACellIntoItsComponents)
{
    make("two_legs", 500);
    const Json diced = kerf_json("dice in.ply --grid 1x1x3 --components --out leg");
    std::set<std::string> names;
    for (const Json& piece : diced["pieces"]) names.insert(piece["file"]);
    EXPECT_EQ(names.size(), diced["pieces"].size());
    EXPECT_TRUE(names.contains("leg.0-0-0.0.obj") || names.contains("leg.0-0-0.1.obj"));
    EXPECT_GT(diced["pieces"].size(), 3u);
}

TEST_F(KerfDice, SaysWhatIsWrongWithItsUse)
{
    make("box", 12);
    for (const char* use :
         {"dice in.ply --out a", "dice in.ply --grid 2x2 --out a", "dice in.ply --grid 0x1x1 --out a",
          "dice in.ply --grid 2x2x2x2 --out a", "dice in.ply --grid 2x2x2 --size 1,1,1 --out a",
          "dice in.ply --size 1,1,-1 --out a", "dice in.ply --grid 2x2x2 --gap -1 --out a",
          "dice in.ply --grid 2x2x2 --gap nan --out a", "dice in.ply --grid 2x2x2", "dice - --grid 2x2x2 --out a"})
        EXPECT_EQ(kerf(use).status, 2) << use;
    EXPECT_EQ(kerf("dice in.ply --size 1e-9,1,1 --out a").status, 1);
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"in.ply"});
}

}  // namespace
}  // namespace kerf::tools
