#include <array>
#include <string>
#include <utility>
#include <vector>

#include "common/io/test_files.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"

namespace kerf::core::io {
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

/// What the keyword promises comes in this order: of the letters where one program alone writes them so, otherwise the
/// description's.
TEST_F(OffTest, TakesTheLettersOfTheKeywordInAnyOrderAndCase)
{
    const auto file_of = [](const std::string& keyword, const std::string& data) {
        return keyword + "\n3 1 0\n0 0 0 " + data + "\n1 0 0 " + data + "\n0 1 0 " + data + "\n3 0 1 2\n";
    };
    const std::string n = "0 0 1 ", c = "255 0 51 255 ", st = "0.5 0.25 ";
    const std::vector<std::pair<std::string, std::string>> files{
        {"STCNOFF", n + c + st},
        {"CSTNOFF", n + c + st},
        {"stcnoff", n + c + st},
        {"NCOFF", c + n},
        {"NCSTOFF", c + n + st},
        {"NSTCOFF", c + n + st},
        {"NCoff", c + n},
        {"CSTOFF", c + st},
        {"Off", ""},
        {"off", ""},
        {"noff", n},
        {"STOFF", st},
        {"COFF", c},
        {"COFF", "1.0 0.0 0.2 "},
    };
    for (const auto& [keyword, data] : files) {
        const Read found = read("a.off", file_of(keyword, data));
        EXPECT_EQ(found.notes, "") << keyword;
        ASSERT_EQ(found.soup.triangles, (Buffer<Triangle>{{0, 1, 2}})) << keyword;
        EXPECT_EQ(found.soup.vertices[1].position, glm::vec3(1, 0, 0)) << keyword;
        EXPECT_EQ(found.soup.has_normals, contains(data, n)) << keyword;
        const Vertex& last = found.soup.vertices[2];
        EXPECT_EQ(last.normal, contains(data, n) ? glm::vec3(0, 0, 1) : glm::vec3(0)) << keyword;
        EXPECT_EQ(last.uv, contains(data, st) ? glm::vec2(0.5f, 0.25f) : glm::vec2(0)) << keyword;
        if (!contains(keyword, "C")) continue;
        ASSERT_EQ(found.soup.streams.size(), 1u) << keyword;
        EXPECT_EQ(found.soup.streams[0].values, (Buffer<float>{1, 0, 0.2f, 1, 1, 0, 0.2f, 1, 1, 0, 0.2f, 1}))
            << keyword;
    }
}

TEST_F(OffTest, TakesElementsThatShareLines)
{
    const std::string square = "0 0 0 1 0 0 1 1 0 0 1 0 ", faces = "3 0 1 2 3 0 2 3";
    for (const std::string& text :
         std::vector<std::string>{"OFF 4 2 0 " + square + faces, "OFF\n4 2 0\n" + square + "\n" + faces,
                                  "OFF 4 2 0\n" + square + faces + "\n",
                                  "off 4 2 0 # all\n0 0 0 1 0 0 1\n1 0 0 1 0\n3 0 1 2 255 0 0\n3 0 2 3 0\n",
                                  "4 2 0 " + square + "\n3 0 1 2\n3 0 2 3\n"}) {
        const Read found = read("a.off", text);
        EXPECT_EQ(found.soup.triangles, (Buffer<Triangle>{{0, 1, 2}, {0, 2, 3}})) << text;
        EXPECT_EQ(found.soup.vertices[2].position, glm::vec3(1, 1, 0)) << text;
        EXPECT_EQ(found.notes, "") << text;
    }
    const Read all = read("a.off",
                          "STCNOFF 3 1 0 0 0 0 0 0 1 255 0 51 255 0.5 0.25 1 0 0 0 0 1 255 0 51 255 0.5 0.25 "
                          "0 1 0 0 0 1 255 0 51 255 0.5 0.25 3 0 1 2");
    EXPECT_EQ(all.soup.vertices[2].position, glm::vec3(0, 1, 0));
    EXPECT_EQ(all.soup.vertices[2].uv, glm::vec2(0.5f, 0.25f));
    EXPECT_EQ(all.soup.streams.at(0).values[2], 0.2f);
}

TEST_F(OffTest, TakesCountsOnLinesOfTheirOwn)
{
    for (const char* head : {"OFF\n4\n1\n0\n", "OFF\n4\n1\n", "OFF\n\n4 # v\n\n1 # f\n0 # e\n", "OFF\n4.0 1 0\n"})
        for (const char* face : {"4 0 1 2 3\n", "4\n0 1 2 3\n", "4.0 0.0 1.0 2.0 3.0\n"}) {
            const TriangleSoup soup = soup_of("a.off", head + std::string(kSquare) + face);
            EXPECT_EQ(soup.triangles.size(), 2u) << head << face;
            EXPECT_EQ(soup.vertices[3].position, glm::vec3(0, 1, 0)) << head << face;
        }
}

TEST_F(OffTest, CompletesVerticesThatLackWhatTheKeywordPromisesAndNotesIt)
{
    const std::string incomplete = " vertices without the numbers that the keyword promises completed";
    const std::string longer = " lines with more numbers than they need read without them";
    const auto file_of = [](const std::string& keyword, const std::string& data) {
        return keyword + "\n3 1 0\n0 0 0 " + data + "\n1 0 0 " + data + "\n0 1 0 " + data + "\n3 0 1 2 0.5 0.5 0.5\n";
    };
    const std::vector<std::array<std::string, 3>> files{
        {"COFF", "", "3" + incomplete},
        {"COFF", "1 2", "3" + incomplete},
        {"STOFF", "0.5", "3" + incomplete},
        {"NOFF", "", "3" + incomplete},
        {"STCNOFF", "0 0 1", "3" + incomplete},
        {"NOFF", "nan nan nan", "3 normals that are not finite numbers made anew"},
        {"NOFF", "0 0 x", "3 normals that are not finite numbers made anew"},
        {"STOFF", "nan 0", "3 texture coordinates that are not finite numbers set to 0"},
        {"COFF", "nan 0 0", "3 values of further attributes that are not finite numbers set to 0"},
        {"OFF", "255 0 0", "3" + longer},
        {"NOFF", "0 0 1 7", "3" + longer},
    };
    for (const auto& [keyword, data, notes] : files) {
        const Read found = read("a.off", file_of(keyword, data));
        EXPECT_EQ(found.notes, notes) << keyword << " " << data;
        EXPECT_EQ(found.soup.triangles, (Buffer<Triangle>{{0, 1, 2}})) << keyword << " " << data;
        EXPECT_EQ(found.soup.vertices[1].position, glm::vec3(1, 0, 0)) << keyword << " " << data;
    }
    EXPECT_EQ(read("a.off", "OFF\n4 3 0\n" + std::string(kSquare) + "0\n2 0 1\n3 0 1 2\n").notes,
              "2 faces of fewer than three corners passed over");
}

TEST_F(OffTest, ReadsAsManyDimensionsAsANumberSaysIfItIsThree)
{
    for (const char* header :
         {"nOFF\n3\n4 1 0\n", "nOFF 3\n4 1 0\n", "nOFF3\n4 1 0\n", "nOFF\n# dimensions\n3 4 1 0\n"}) {
        const Read found = read("a.off", header + std::string(kSquare) + "4 0 1 2 3\n");
        EXPECT_EQ(found.soup.triangles.size(), 2u) << header;
        EXPECT_EQ(found.notes, "") << header;
    }
}

TEST_F(OffTest, NotesLinesBehindTheLastFace)
{
    const Read found = read("a.off", "OFF\n4 1 0\n" + std::string(kSquare) + "3 0 1 2 1\n# more\n3 0 2 3\n");
    EXPECT_EQ(found.soup.triangles.size(), 1u);
    EXPECT_EQ(found.notes, "1 lines behind the last one that is expected passed over");
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
    for (const char* keyword : {"OF", "<html>", "NNOFF", "STSTOFF", "XOFF", "OFFF", "SOFF"})
        EXPECT_TRUE(contains(error_of("a.off", std::string(keyword) + "\n1 1 1\n"), "instead of OFF")) << keyword;
    for (const char* keyword : {"nOFF", "4nOFF", "ST4OFF", "N4OFF", "STnOFF", "nOFF4"})
        EXPECT_TRUE(contains(error_of("a.off", std::string(keyword) + "\n1 1 1\n"), "three-dimensional")) << keyword;
    EXPECT_TRUE(contains(error_of("a.off", "# x\n\n"), "nothing in it but blanks and comments"));
    EXPECT_TRUE(contains(error_of("a.off", "OFF\n4 1 0\n0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n"),
                         "line 3: a coordinate is missing"));
    EXPECT_TRUE(
        contains(error_of("a.off", "OFF\n4 2 0\n0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n"), "it may be cut off"));
}

TEST_F(OffTest, WritesPointsAndTrianglesThatReadBackBitForBit)
{
    // Seams of the cylinder have two vertices a point; the file has one line.
    const IndexedMesh mesh = *repair(shapes::cylinder(0.3f, 1.1f, 7)).mesh;
    write_mesh(folder_ / "a.off", mesh);
    const TriangleSoup soup = read_soup(folder_ / "a.off");
    ASSERT_EQ(soup.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(soup.vertices.size(), mesh.point_count);
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(soup.vertices[soup.triangles[t][i]].position, mesh.vertices[mesh.triangles[t][i]].position);
}

}  // namespace
}  // namespace kerf::core::io
