#include "io/test_files.h"

namespace kerf::io {
namespace {

using OffTest = MeshFileTest;

constexpr const char* kSquare = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST_F(OffTest, ReadsPolygonsWithCommentsAndColoursBehindThem)
{
    const TriangleSoup soup = soup_of(
        "a.off", "OFF # a square\n# counts\n\n4 1 0\n" + std::string(kSquare) + "# face\n4  0 1 2 3  255 0 0\n");
    EXPECT_EQ(soup.vertices.size(), 4u);
    EXPECT_EQ(soup.triangles, (Buffer<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_FALSE(soup.has_normals);
    EXPECT_TRUE(soup.streams.empty());
}

TEST_F(OffTest, KeepsVerticesThatNoFaceUses)
{
    EXPECT_EQ(soup_of("a.off", "OFF\n4 1 0\n" + std::string(kSquare) + "3 0 1 2\n").vertices.size(), 4u);
}

TEST_F(OffTest, TakesTheKeywordOnTheLineOfTheCountsOrNotAtAll)
{
    for (const char* head : {"OFF 4 1 0\n", "4 1 0\n", "OFF4 1 0\n", "OFF\n4 1\n"})
        EXPECT_EQ(soup_of("a.off", head + std::string(kSquare) + "4 0 1 2 3\n").triangles.size(), 2u) << head;
}

TEST_F(OffTest, ReadsNormalsColoursAndTextureCoordinates)
{
    const TriangleSoup soup = soup_of("a.off",
                                      "STCNOFF\n3 1 0\n0 0 0  0 0 1  255 0 51  0.5 0.25\n1 0 0  0 0 1  0 0 0 0  0 0\n"
                                      "0 1 0  0 0 1  0.5 0.5 0.5 1  0 1\n3 0 1 2\n");
    EXPECT_TRUE(soup.has_normals);
    EXPECT_EQ(soup.vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(soup.vertices[0].uv, glm::vec2(0.5f, 0.25f));
    ASSERT_EQ(soup.streams.size(), 1u);
    EXPECT_EQ(soup.streams[0].name, "color");
    EXPECT_EQ(soup.streams[0].width, 4u);
    EXPECT_EQ(soup.streams[0].values, (Buffer<float>{1, 0, 0.2f, 1, 0, 0, 0, 0, 0.5f, 0.5f, 0.5f, 1}));
}

TEST_F(OffTest, SaysWhatIsWrong)
{
    const std::string head = "OFF\n4 1 0\n" + std::string(kSquare);
    EXPECT_TRUE(contains(error_of("a.off", head + "3 0 1 4\n"), "line 7: vertex 4 is out of range"));
    EXPECT_TRUE(contains(error_of("a.off", head + "3 0 1 -1\n"), "out of range"));
    EXPECT_TRUE(contains(error_of("a.off", head + "3 0 1\n"), "a vertex index is missing"));
    EXPECT_TRUE(contains(error_of("a.off", head + "4000000000 0 1\n"), "more than the file has room for"));
    EXPECT_TRUE(contains(error_of("a.off", head), "ends after 0 of 1 faces"));
    EXPECT_TRUE(contains(error_of("a.off", head + "2 0 1\n"), "no triangles"));
    EXPECT_TRUE(contains(error_of("a.off", "OFF\n4000000000 1 0\n0 0 0\n"), "more than the file has room for"));
    EXPECT_TRUE(contains(error_of("a.off", "OFF\n-3 1 0\n0 0 0\n"), "negative"));
    EXPECT_TRUE(contains(error_of("a.off", "OFF BINARY\n"), "binary"));
    EXPECT_TRUE(contains(error_of("a.off", "4OFF\n1 1 1\n"), "three-dimensional"));
    EXPECT_TRUE(contains(error_of("a.off", "ply\n"), "instead of OFF"));
    EXPECT_TRUE(contains(error_of("a.off", "COFF\n1 1 0\n0 0 0 1 2\n3 0 0 0\n"), "2 numbers for colour"));
}

}  // namespace
}  // namespace kerf::io
