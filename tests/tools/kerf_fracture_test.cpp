#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "tools/program.h"

namespace kerf::tools {
namespace {

class KerfFracture : public ProgramTest
{
protected:
    void make(const std::string& shape, int triangles) const
    {
        ASSERT_EQ(kerf("shape " + shape + " --triangles " + std::to_string(triangles) + " -o in.ply").status, 0);
    }

    /// The JSON of a GLB file.
    Json document(const std::string& name) const
    {
        const std::string bytes = read_text(folder_ / name);
        std::uint32_t length = 0;
        std::memcpy(&length, bytes.data() + 12, 4);
        return Json::parse(bytes.substr(20, length));
    }
};

/// What `assimp info FILE` says; empty if the program is not there.
std::string said_by_assimp(const std::string& file)
{
    std::string text;
    FILE* const pipe = popen(("assimp info '" + file + "' 2>/dev/null").c_str(), "r");
    if (pipe == nullptr) return text;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
    pclose(pipe);
    return text;
}

/// The number after a title, at the start of a line.
long number_after(const std::string& text, const std::string& title)
{
    const std::size_t place = text.find("\n" + title);
    return place == std::string::npos ? -1 : std::atol(text.c_str() + place + 1 + title.size());
}

TEST_F(KerfFracture, AnotherProgramReadsTheScene)
{
    make("asteroid", 1000);
    const Json said = kerf_json("fracture in.ply --cells 12 --seed 7 -o out.glb");
    const std::string info = said_by_assimp((folder_ / "out.glb").string());
    if (info.empty()) GTEST_SKIP() << "assimp is not there";
    long triangles = 0;
    for (const Json& piece : said["pieces"]) triangles += piece["triangles"].get<long>();
    EXPECT_EQ(number_after(info, "Nodes:"), long(said["pieces"].size()) + 1) << "and the scene's own";
    EXPECT_EQ(number_after(info, "Faces:"), triangles);
    EXPECT_GE(number_after(info, "Materials:"), 1) << "that of the inside";
}

TEST_F(KerfFracture, WritesANodeForEachPieceThatNamesItsNeighbours)
{
    make("asteroid", 1000);
    const Json whole = kerf_json("info in.ply");
    const Json said = kerf_json("fracture in.ply --cells 12 --pattern impact --at 0,0.4,0 --seed 7 -o out.glb");
    EXPECT_EQ(names_in_folder(), (std::vector<std::string>{"in.ply", "out.glb"}));
    EXPECT_EQ(said["pattern"], "impact");
    EXPECT_EQ(said["pieces"].size(), 12u);
    double volume = 0.0;
    for (const Json& piece : said["pieces"]) {
        EXPECT_EQ(piece["closed"], true);
        volume += piece["volume"].get<double>();
    }
    EXPECT_NEAR(volume, whole["volume"].get<double>(), 1e-6 * volume);

    const Json scene = document("out.glb");
    ASSERT_EQ(scene["nodes"].size(), 12u);
    std::map<std::set<std::string>, std::vector<double>> areas;
    for (const Json& node : scene["nodes"]) {
        EXPECT_FALSE(node.contains("translation"));
        const Json& extras = node["extras"];
        EXPECT_GT(extras["volume"].get<double>(), 0.0);
        EXPECT_EQ(extras["interior_material"], "cap");
        for (const Json& neighbour : extras["neighbours"])
            areas[{node["name"].get<std::string>(), neighbour["piece"].get<std::string>()}].push_back(
                neighbour["area"].get<double>());
    }
    EXPECT_EQ(areas.size(), said["contacts"].size());
    for (const auto& [pieces, seen] : areas) {
        ASSERT_EQ(seen.size(), 2u) << "one of two neighbours does not know the other one";
        EXPECT_EQ(seen[0], seen[1]);
    }
    std::set<std::string> materials;
    for (const Json& material : scene["materials"]) materials.insert(material["name"].get<std::string>());
    EXPECT_TRUE(materials.contains("cap"));
    EXPECT_LE(scene["materials"].size(), 2u) << "those of all pieces are the same";

    const Json read_again = kerf_json("info out.glb");
    EXPECT_EQ(read_again["closed"], true);
    EXPECT_NEAR(read_again["volume"].get<double>(), volume, 1e-5 * volume);
}

TEST_F(KerfFracture, MovesPiecesApart)
{
    make("box", 12);
    ASSERT_EQ(kerf("fracture in.ply --cells 5 --explode 0.5 -o out.glb").status, 0);
    const Json scene = document("out.glb");
    for (const Json& node : scene["nodes"])
        for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(node["translation"][i].get<double>(), 0.5 * node["extras"]["centre_of_mass"][i].get<double>(),
                        1e-6);
    const Json whole = kerf_json("info in.ply"), apart = kerf_json("info out.glb");
    EXPECT_GT(apart["bounds"]["max"][0].get<double>(), whole["bounds"]["max"][0].get<double>());
}

TEST_F(KerfFracture, TheSameSeedGivesTheSameFile)
{
    make("torus", 1000);
    for (const char* pattern : {"uniform", "crack", "grid", "splinters"}) {
        const std::string command = std::string("fracture in.ply --cells 9 --seed 5 --pattern ") + pattern + " -o ";
        ASSERT_EQ(kerf(command + "a.glb").status, 0);
        ASSERT_EQ(kerf(command + "b.glb").status, 0);
        EXPECT_EQ(read_text(folder_ / "a.glb"), read_text(folder_ / "b.glb")) << pattern;
    }
}

TEST_F(KerfFracture, NeedsNoFileToSayWhatThereIs)
{
    make("asteroid", 300);
    const auto said = kerf("fracture in.ply --cells 4");
    EXPECT_EQ(said.status, 0);
    EXPECT_NE(said.out.find("4 pieces of "), std::string::npos) << said.out;
    EXPECT_EQ(names_in_folder(), (std::vector<std::string>{"in.ply"}));
}

TEST_F(KerfFracture, RefusesWhatItCannotDo)
{
    make("asteroid", 300);
    EXPECT_EQ(kerf("fracture in.ply -o out.obj").status, 2);
    EXPECT_EQ(kerf("fracture in.ply --cells 0").status, 2);
    EXPECT_EQ(kerf("fracture in.ply --pattern spiral").status, 2);
    EXPECT_EQ(kerf("fracture in.ply --direction 0,0,0").status, 2);
    EXPECT_EQ(kerf("fracture in.ply --explode 1e300 -o out.glb").status, 2);
    write("open.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const auto open = kerf("fracture open.obj -o out.glb");
    EXPECT_EQ(open.status, 1);
    EXPECT_NE(open.err.find("open"), std::string::npos) << open.err;
    EXPECT_EQ(kerf("fracture in.ply -o nowhere/out.glb").status, 1);
    EXPECT_EQ(names_in_folder(), (std::vector<std::string>{"in.ply", "open.obj"}));
}

}  // namespace
}  // namespace kerf::tools
