#include <array>
#include <set>
#include <sstream>

#include "common/io/test_files.h"

// Real meshes that nobody on this project made (../shared/meshes/INDEX.md has their facts).

namespace kerf::core::io {
namespace {

struct Expected
{
    std::string file;
    std::size_t triangles;
    std::size_t vertices;   ///< as stored; for OBJ see CountVerticesOfObjFilesAsTriples
    std::size_t positions;  ///< different ones
};

void PrintTo(const Expected& expected, std::ostream* out)
{
    *out << expected.file;
}

class SharedMesh : public ::testing::TestWithParam<Expected>
{
protected:
    void SetUp() override
    {
        path_ = std::filesystem::path(KERF_SHARED_MESHES_DIR) / GetParam().file;
        if (!std::filesystem::exists(path_)) GTEST_SKIP() << "the shared meshes are not here";
    }
    std::filesystem::path path_;
};

TEST_P(SharedMesh, HasTheCountsOfTheIndex)
{
    const TriangleSoup soup = read_soup(path_);
    EXPECT_EQ(soup.triangles.size(), GetParam().triangles);
    EXPECT_EQ(count_positions(soup.vertices), GetParam().positions);
    EXPECT_EQ(soup.vertices.size(), GetParam().vertices);
}

// The index counts the v lines of OBJ files; here are the different v/vt/vn triples where there are more.
INSTANTIATE_TEST_SUITE_P(
    All, SharedMesh,
    ::testing::Values(Expected{"chess_rook.obj", 1260, 1128, 632}, Expected{"chess_knight.obj", 6624, 3403, 3314},
                      Expected{"suzanne_monkey.glb", 968, 1966, 505}, Expected{"milktruck_geom.glb", 3624, 3564, 1840},
                      Expected{"mengerSponge3.glb", 21598, 7983, 7983}, Expected{"spot.obj", 5856, 3225, 2930},
                      Expected{"bob.obj", 668, 412, 334}, Expected{"boat.obj", 32416, 16665, 16210},
                      Expected{"skull.obj", 100002, 49999, 49999}, Expected{"knot2.off", 11520, 5760, 5760},
                      Expected{"cheese.off", 17786, 8629, 8629}, Expected{"bones.off", 4204, 2154, 2154},
                      Expected{"mech-holes-shark.off", 10192, 5246, 5246}, Expected{"boeing.off", 2564, 2741, 1264},
                      Expected{"non_manifold_face_graph.off", 21, 24, 21}, Expected{"cubes.off", 24, 14, 14},
                      Expected{"ADIS16480.STL", 7436, 22308, 3672},
                      Expected{"mni_t1iso60_804k.ply", 804148, 402178, 402178}),
    [](const auto& test) {
        std::string name = test.param.file;
        for (char& c : name)
            if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
        return name;
    });

/// The corners of OBJ files, read again in the simplest way.
TEST(SharedMeshes, CountVerticesOfObjFilesAsTriples)
{
    const std::filesystem::path folder = KERF_SHARED_MESHES_DIR;
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared meshes are not here";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".obj") continue;
        std::set<std::string> triples;
        std::ifstream in(entry.path());
        for (std::string line; std::getline(in, line);) {
            std::istringstream words(line);
            std::string word;
            if (!(words >> word) || word != "f") continue;
            while (words >> word) triples.insert(word);
        }
        EXPECT_EQ(read_soup(entry.path()).vertices.size(), triples.size()) << entry.path();
    }
}

}  // namespace
}  // namespace kerf::core::io
