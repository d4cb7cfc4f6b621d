#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "common/io/test_files.h"

namespace kerf::core::io {
namespace {

using ObjTest = MeshFileTest;

TEST_F(ObjTest, CountsVerticesAsDifferentTriples)
{
    const TriangleSoup soup = soup_of("a.obj",
                                      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\n"
                                      "vt 0 0\nvt 1 0.25\nvt 1 1\nvn 0 0 1\nvn 0 0 -1\n"
                                      "f 1/1/1 2/2/1 3/3/1\nf 1/1/1 3/3/1 4/2/1\nf 1/1/2 4/2/2 3/3/2\n");
    EXPECT_EQ(soup.vertices.size(), 7u);
    ASSERT_EQ(soup.triangles.size(), 3u);
    EXPECT_TRUE(soup.has_normals);
    const Vertex& v = soup.vertices[soup.triangles[0][1]];
    EXPECT_EQ(v.position, glm::vec3(1, 0, 0));
    EXPECT_EQ(v.uv, glm::vec2(1, 0.25f));
    EXPECT_EQ(v.normal, glm::vec3(0, 0, 1));
    EXPECT_TRUE(soup.materials.empty());
}

TEST_F(ObjTest, CountsNegativeIndicesBackwardsFromTheLatest)
{
    const TriangleSoup soup = soup_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 5 5 5\nf -4 -3 -1\n");
    EXPECT_EQ(soup.vertices[soup.triangles[0][0]].position, glm::vec3(0, 0, 0));
    EXPECT_EQ(soup.vertices[soup.triangles[1][2]].position, glm::vec3(5, 5, 5));
    EXPECT_FALSE(soup.has_normals);
}

TEST_F(ObjTest, TakesContinuationsCommentsAndCrLf)
{
    const TriangleSoup soup =
        soup_of("a.obj",
                "# head\r\no thing\r\ng part\r\ns off\r\nv 0 0 \\\r\n0\r\nv 1 0 0 # x\r\nv 1 1 0\r\n"
                "v 0 1 0\r\nf 1 2\\\r\n 3 4\r\n");
    EXPECT_EQ(soup.triangles.size(), 2u);
    EXPECT_EQ(soup.vertices.size(), 4u);
}

TEST_F(ObjTest, ReadsNumbersCorrectlyRounded)
{
    const TriangleSoup soup = soup_of("a.obj",
                                      "v 1.00000005960464477539062500001 -2.3360191035254516 1e-50\nv 1 0 0\nv 0 1 -0\n"
                                      "f 1 2 3\n");
    const glm::vec3& p = soup.vertices[0].position;
    EXPECT_EQ(p.x, std::nextafter(1.0f, 2.0f));
    EXPECT_EQ(p.y, -2.3360191035254516f);
    EXPECT_EQ(p.z, 0.0f);
    EXPECT_FALSE(std::signbit(soup.vertices[2].position.z));
}

TEST_F(ObjTest, ReadsMaterialsWithColourAndTexture)
{
    write("my materials.mtl",
          "newmtl red skin\nKd 1 0 0.5\nd 0.25\nmap_Kd -s 2 2 -clamp on wet peel.png\nnewmtl blue\nKd 0 0 1\nTr 0.5\n"
          "map_Kd\nKd x y z\n");
    const TriangleSoup soup =
        soup_of("a.obj",
                "mtllib my materials.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl red skin\n"
                "f 1 2 3\nusemtl blue\nf 3 2 1\nusemtl red skin\nf 3 2 1\nusemtl unknown\nf 1 2 3\n");
    ASSERT_EQ(soup.materials.size(), 4u);
    EXPECT_EQ(soup.triangle_materials, (std::vector<std::uint32_t>{0, 1, 2, 1, 3}));
    EXPECT_EQ(soup.materials[0].name, "");
    EXPECT_EQ(soup.materials[1].name, "red skin");
    EXPECT_EQ(soup.materials[1].colour, glm::vec4(1, 0, 0.5f, 0.25f));
    EXPECT_EQ(soup.materials[1].texture, "wet peel.png");
    EXPECT_EQ(soup.materials[2].colour, glm::vec4(0, 0, 1, 0.5f));
    EXPECT_EQ(soup.materials[2].texture, "");
    EXPECT_EQ(soup.materials[3].name, "unknown");
}

TEST_F(ObjTest, ReadsWithoutItsMaterialFile)
{
    const TriangleSoup soup = soup_of("a.obj", "mtllib gone.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    ASSERT_EQ(soup.materials.size(), 1u);
    EXPECT_EQ(soup.materials[0].name, "m");
}

TEST_F(ObjTest, ReadsMaterialsFromItsFolderAndBelowOnly)
{
    std::filesystem::create_directories(file("parts/below"));
    for (const char* name : {"a.mtl", "parts/below/a.mtl"}) write(name, "newmtl m\nKd 1 0 0\n");
    const auto colour_with = [&](const std::string& library) {
        const std::string triangle = "\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
        return soup_of("parts/a.obj", "mtllib " + library + triangle).materials.at(0).colour;
    };
    EXPECT_EQ(colour_with("below/a.mtl"), glm::vec4(1, 0, 0, 1));
    EXPECT_EQ(colour_with("../a.mtl"), glm::vec4(1));
    EXPECT_EQ(colour_with("below/../../a.mtl"), glm::vec4(1));
    EXPECT_EQ(colour_with(file("a.mtl").string()), glm::vec4(1));
}

TEST_F(ObjTest, ReadsAMaterialFileOnceHoweverOftenItIsNamed)
{
    // 5 MB read 20 000 times would take minutes.
    write("a.mtl", "newmtl m\nKd 1 0 0\n" + std::string(5'000'000, '#'));
    std::string text;
    for (int i = 0; i < 10'000; ++i) text += i % 2 == 0 ? "mtllib a.mtl\n" : "mtllib ./a.mtl .//a.mtl\n";
    text += "usemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    EXPECT_EQ(soup_of("a.obj", text).materials.at(0).colour, glm::vec4(1, 0, 0, 1));
}

TEST_F(ObjTest, ReadsVertexColoursAsAStream)
{
    const TriangleSoup soup = soup_of("a.obj", "v 0 0 0 1 0.5 0.25\nv 1 0 0 0 0 0\nv 0 1 0\nf 3 1 2\n");
    ASSERT_EQ(soup.streams.size(), 1u);
    EXPECT_EQ(soup.streams[0].name, "color");
    EXPECT_EQ(soup.streams[0].values, (Buffer<float>{1, 1, 1, 1, 0.5f, 0.25f, 0, 0, 0}));
}

TEST_F(ObjTest, FillsInNormalsThatOnlySomeCornersLack)
{
    const TriangleSoup soup =
        soup_of("a.obj", "v 0 0 0\nv 2 0 0\nv 0 2 0\nvn 0 1 0\nvn 3 0 4\nvn 0 0 0\nf 1//1 2//2 3\nf 1//3 2//1 3//1\n");
    EXPECT_TRUE(soup.has_normals);
    EXPECT_EQ(soup.vertices[0].normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(soup.vertices[1].normal, glm::vec3(0.6f, 0, 0.8f));
    EXPECT_EQ(soup.vertices[2].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(soup.vertices[3].normal, glm::vec3(0, 0, 1));
}

TEST_F(ObjTest, NamesTheLineThatIsWrong)
{
    const std::string head = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_TRUE(
        contains(error_of("a.obj", head + "f 1 2 4\n"),
                 "line 4: vertex 4 is out of range: there are 3; count from 1, and mend the face or take it out"));
    EXPECT_TRUE(contains(error_of("a.obj", "f 1 2 4\n" + head), "line 1: vertex 4 is out of range: there are 3;"));
    EXPECT_TRUE(contains(error_of("a.obj", head + "f 1 2 0\n"), "line 4: vertex 0 is out of range: the first is 1;"));
    EXPECT_TRUE(contains(error_of("a.obj", head + "f 1 2 -4\n"),
                         "line 4: vertex -4 is out of range: there are 3 before it; mend the face or take it out"));
    EXPECT_TRUE(contains(error_of("a.obj", "v 0 0 0\nf -1 -2 -3\nv 1 0 0\nv 0 1 0\n"), "there are 1 before it"));
    EXPECT_TRUE(contains(error_of("a.obj", head + "f 1 2 99999999999999999999\n"), "line 4"));
    EXPECT_TRUE(contains(error_of("a.obj", head + "f 1 2 -9223372036854775808\n"), "line 4"));
    EXPECT_TRUE(contains(error_of("a.obj", head + "f 1 2 2.5\n"), "line 4"));
    EXPECT_TRUE(contains(error_of("a.obj", head + "f 1 2\n"), "no triangles"));
    EXPECT_TRUE(contains(error_of("a.obj", "v 0 0\nf 1 1 1\n"), "line 1: a coordinate is missing"));
    EXPECT_TRUE(
        contains(error_of("a.obj", "v 0 nan 0\nf 1 1 1\n"),
                 "line 1: a coordinate is 'nan', which is not finite; write a number, or take it and its faces out"));
    EXPECT_TRUE(
        contains(error_of("a.obj", "v 0 1e99 0\nf 1 1 1\n"), "too large for single precision; scale the mesh down"));
    EXPECT_TRUE(contains(error_of("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\n\nv 0 -1.#IND 0\n"),
                         "line 5: a coordinate is '-1.#IND', which is not finite"));
    EXPECT_TRUE(contains(error_of("a.obj", head), "no triangles"));
}

constexpr const char* kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST_F(ObjTest, ReadsFacesBeforeWhatTheyName)
{
    // Behind the faces: all; the vertices; the normals and texture coordinates; some of each.
    const std::string vertices = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0.5 0.5 0\n";
    const std::string attributes = "vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n";
    const std::string faces = "f 1/1/1 2/2/2 3/3/1 4/1/2\nusemtl m\nf 1/3/2 3/2/1 2/1/1\n";
    const std::string last = "vn 1 0 0\n";
    const TriangleSoup expected = soup_of("a.obj", vertices + attributes + last + faces);
    // The arrow is not convex: a fan from its first corner would be another surface.
    ASSERT_EQ(expected.triangles.size(), 3u);
    for (const std::string& text :
         {faces + vertices + attributes + last, attributes + faces + vertices + last,
          vertices + faces + attributes + last, "v 0 0 0\n" + faces + attributes + vertices.substr(8) + last}) {
        const Read found = read("a.obj", text);
        EXPECT_EQ(found.soup.triangles, expected.triangles) << text;
        EXPECT_EQ(all_corners(found.soup), all_corners(expected)) << text;
        EXPECT_EQ(found.soup.triangle_materials, expected.triangle_materials) << text;
        EXPECT_EQ(found.notes, "") << text;
    }
}

TEST_F(ObjTest, CountsNegativeIndicesFromTheirPlaceInTheFileWhateverIsReadAhead)
{
    // Line 4 needs what stands behind it; the next line counts from where it stands all the same.
    const TriangleSoup soup = soup_of("a.obj", std::string(kTriangle) +
                                                   "f 1//2 2 5\nf -3 -2 -1\nv 5 5 5\nvn 0 0 1\n"
                                                   "f -1//-1 -2 -3\nv 6 6 6\nvn 1 0 0\nf -1 -2 1\n");
    const auto corner = [&](std::size_t t, std::size_t k) { return soup.vertices[soup.triangles[t][k]]; };
    EXPECT_EQ(corner(0, 2).position, glm::vec3(6, 6, 6));
    EXPECT_EQ(corner(0, 0).normal, glm::vec3(1, 0, 0));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(corner(1, k).position, glm::vec3(k == 1, k == 2, 0));
    EXPECT_EQ(corner(2, 0).position, glm::vec3(5, 5, 5));
    EXPECT_EQ(corner(2, 0).normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(corner(2, 1).position, glm::vec3(0, 1, 0));
    EXPECT_EQ(corner(3, 0).position, glm::vec3(6, 6, 6));
    EXPECT_EQ(corner(3, 1).position, glm::vec3(5, 5, 5));
}

/// A file that is read as one triangle, with what is noted.
struct Lenient
{
    std::string text;
    std::string notes;
};

TEST_F(ObjTest, PassesOverWhatSaysNothingOfTheSurfaceAndNotesIt)
{
    const std::string v = kTriangle, f = "f 1 2 3\n", uv_f = "f 1/1 2/1 3/1\n", n_f = "f 1//1 2//1 3//1\n";
    const std::string normals = "1 normals that are not finite numbers made anew";
    const std::string uvs = "1 texture coordinates that are not finite numbers set to 0";
    const std::string absent = " references to normals and texture coordinates that are not there left out";
    const std::string few = " faces of fewer than three corners passed over";
    const std::string unused = "1 vertices of no face that are not finite numbers passed over";
    const std::vector<Lenient> files{
        {v + "vn nan nan nan\n" + n_f, normals},
        {v + "vn -1.#IND -1.#IND 1.#QNAN\n" + n_f, normals},
        {v + "vn 1e40 0 0\n" + f, normals},
        {v + "vn 0 1\n" + n_f, normals},
        {v + "vn\nvn x y z\n" + f, "2 normals that are not finite numbers made anew"},
        {v + "vt nan nan\n" + uv_f, uvs},
        {v + "vt\n" + uv_f, uvs},
        {v + "vt 0.5\nvt 0.5 0.5 0\n" + uv_f, ""},
        {v + "v nan nan nan\n" + f, unused},
        {v + "v 1e40 0 0\n" + f, unused},
        {v + "v 1 2. 3.1+e2\n" + f, unused},
        {v + "v\n" + f, unused},
        {v + "v 0 0 0 1\nv 0 0 0 1.0\n" + f, ""},
        {v + "v 0 0 0 2\nv 0 0 0 x\nv 0 0 0 1 2\n" + f, "3 weights and other words behind coordinates passed over"},
        {v + "f\n" + f, "1" + few},
        {v + "f 1\nf 1 2\n" + f, "2" + few},
        {v + "f 1/0/0 2/0/0 3/0/0\n", "6" + absent},
        {v + "f 1//7 2//7 3//-1\n", "3" + absent},
        {v + "f 1/1/1 2/x 3/1.5/\n", "4" + absent},
        {v + "f 1/// 2// 3/\n", "1" + absent},
        {v + "fo 1 2 3\n", "1 faces in the old spelling fo read"},
        {v + "f 1.0 2e0 3\n", "2 integers written with a point or an exponent read"},
        {v + "f 1 2 3 # a remark\nf 1 2#\n", "1" + few},
        {v + "l 1 2\np 1 2 3\n" + f, "2 lines and points passed over"},
        {v + "cstype bezier\ndeg 3\nsurf 0 1 0 1 1 2 3\nend\n" + f,
         "4 statements of free-form curves and surfaces passed over"},
        {v + "hello world\n" + f, "1 statements of other kinds passed over"},
        {"mg 1\no x\ng\ns off\nbevel on\nlod 1\nusemtl\n" + v + f, ""},
    };
    for (const Lenient& lenient : files) {
        const Read found = read("a.obj", lenient.text);
        EXPECT_EQ(found.notes, lenient.notes) << lenient.text;
        ASSERT_EQ(found.soup.triangles.size(), 1u) << lenient.text;
        EXPECT_EQ(count_positions(found.soup.vertices), 3u) << lenient.text;
        for (const Vertex& vertex : found.soup.vertices)
            EXPECT_TRUE(vertex.normal == glm::vec3(0, 0, 1) || vertex.normal == glm::vec3(0)) << lenient.text;
    }
}

TEST_F(ObjTest, TakesIndicesOfAttributesAsItTakesThoseOfVertices)
{
    const std::string lists = std::string(kTriangle) + "vt 0.5 0.25\nvn 0 0 1\n";
    for (const auto& [face, notes] : std::vector<std::pair<std::string, std::string>>{
             {"f 1.0/1.0/1.0 2.0/1.0/1.0 3.0/1.0/1.0\n", "9 integers written with a point or an exponent read"},
             {"f +1/+1/+1 +2/+1/+1 +3/+1/+1\n", ""}}) {
        const Read found = read("a.obj", lists + face);
        EXPECT_EQ(found.notes, notes) << face;
        ASSERT_EQ(found.soup.vertices.size(), 3u) << face;
        EXPECT_EQ(found.soup.vertices[0].uv, glm::vec2(0.5f, 0.25f)) << face;
        EXPECT_EQ(found.soup.vertices[0].normal, glm::vec3(0, 0, 1)) << face;
    }
}

TEST_F(ObjTest, RefusesCoordinatesOfFacesThatAreNoNumbersWithTheirLine)
{
    EXPECT_TRUE(contains(error_of("a.obj", "v 0 0 0\nv 1 0 3.1+e2\nv 0 1 0\nf 1 2 3\n"),
                         "line 2: a coordinate is '3.1+e2', which is not a number"));
    EXPECT_TRUE(contains(error_of("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1\nf 1 2 3\n"), "line 3: a coordinate is missing"));
}

TEST_F(ObjTest, MakesNormalsThatAreNoNumbersAnewAndKeepsTheOthers)
{
    const TriangleSoup soup = soup_of("a.obj", std::string(kTriangle) + "vn 0 1 0\nvn nan 0 1\nf 1//1 2//2 3//1\n");
    EXPECT_TRUE(soup.has_normals);
    EXPECT_EQ(soup.vertices[0].normal, glm::vec3(0, 1, 0));
    EXPECT_EQ(soup.vertices[1].normal, glm::vec3(0, 0, 1));
}

TEST_F(ObjTest, TakesWeightsAndColoursThatAreNoNumbers)
{
    const Read weights = read("a.obj", "v 0 0 0 1\nv 1 0 0 nan\nv 0 1 0 0.5 1\nf 1 2 3\n");
    EXPECT_TRUE(weights.soup.streams.empty());
    const Read colours = read("a.obj", "v 0 0 0 1 nan 0.5\nv 1 0 0\nv 0 1 0 0.5 1 1 1\nf 1 2 3\n");
    ASSERT_EQ(colours.soup.streams.size(), 1u);
    EXPECT_EQ(colours.soup.streams[0].values, (Buffer<float>{1, 0, 0.5f, 1, 1, 1, 0.5f, 1, 1}));
    EXPECT_EQ(colours.notes, "1 values of further attributes that are not finite numbers set to 0");
}

TEST_F(ObjTest, ReadsBackBitForBitWhatItWrote)
{
    const IndexedMesh mesh = sample_mesh();
    write_mesh(file("a.obj"), mesh);
    const TriangleSoup soup = read_soup(file("a.obj"));
    EXPECT_EQ(all_corners(soup), all_corners(mesh, false));
    EXPECT_EQ(count_positions(soup.vertices), 4u);
    EXPECT_EQ(names_in_folder(), (std::vector<std::string>{"a.mtl", "a.obj"}));
}

TEST_F(ObjTest, WritesGroupsWithTheirMaterials)
{
    const IndexedMesh mesh = sample_mesh();
    write_mesh(file("a.obj"), mesh);
    const TriangleSoup soup = read_soup(file("a.obj"));
    ASSERT_EQ(soup.materials.size(), 3u);
    EXPECT_EQ(soup.triangle_materials, (std::vector<std::uint32_t>{0, 0, 1, 2}));
    EXPECT_EQ(soup.materials[0].name, "skin");
    EXPECT_EQ(soup.materials[0].colour, mesh.materials[0].colour);
    EXPECT_EQ(soup.materials[0].texture, "peel.png");
    EXPECT_EQ(soup.materials[1].name, "surface") << "a material without a name is called like its group";
    EXPECT_EQ(soup.materials[2].name, "flesh");
    EXPECT_EQ(soup.materials[2].colour, mesh.materials[2].colour);

    std::istringstream lines(read_text(file("a.obj")));
    std::vector<std::string> structure;
    for (std::string line; std::getline(lines, line);) {
        const std::string keyword = line.substr(0, line.find(' '));
        if (keyword == "g" || keyword == "usemtl") structure.push_back(line);
        if (keyword == "f" && structure.back() != "f") structure.push_back("f");
    }
    EXPECT_EQ(structure, (std::vector<std::string>{"g surface", "usemtl skin", "f", "usemtl surface", "f", "g cap",
                                                   "usemtl flesh", "f"}));
}

TEST_F(ObjTest, WritesOnePositionForEachPoint)
{
    IndexedMesh mesh = sample_mesh();
    write_mesh(file("a.obj"), mesh);
    const std::string text = read_text(file("a.obj"));
    std::size_t positions = 0;
    for (std::size_t at = text.find("\nv "); at != std::string::npos; at = text.find("\nv ", at + 1)) ++positions;
    EXPECT_EQ(positions, mesh.point_count);
}

TEST_F(ObjTest, KeepsMaterialsApartThatShareAName)
{
    IndexedMesh mesh = sample_mesh();
    mesh.materials = {{"m", glm::vec4(1.0f), ""}, {"m", glm::vec4(1.0f), ""}, {" a\nb \\", glm::vec4(1.0f), ""}};
    write_mesh(file("a.obj"), mesh);
    const TriangleSoup soup = read_soup(file("a.obj"));
    ASSERT_EQ(soup.materials.size(), 3u);
    EXPECT_EQ(soup.materials[0].name, "m");
    EXPECT_EQ(soup.materials[1].name, "m_2");
    EXPECT_EQ(soup.materials[2].name, "a_b");
    EXPECT_EQ(names_in_folder(), std::vector<std::string>{"a.obj"}) << "names alone need no .mtl file";
}

/// The names that a material file has, in order.
std::vector<std::string> new_materials(const std::string& text)
{
    const std::string keyword = "newmtl ";
    std::vector<std::string> names;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (line.starts_with(keyword)) names.push_back(line.substr(keyword.size()));
    return names;
}

TEST_F(ObjTest, NumbersMaterialsThatShareANameBesideOnesThatAreCalledSoAlready)
{
    IndexedMesh mesh = sample_mesh();
    mesh.materials.clear();
    for (const char* name : {"a", "a", "a_2", "a_2", "a_3", "a", "a_2_2", ""})
        mesh.materials.push_back({name, glm::vec4(0.5f), ""});
    write_mesh(file("a.obj"), mesh);
    EXPECT_EQ(new_materials(read_text(file("a.mtl"))),
              (std::vector<std::string>{"a", "a_2", "a_2_2", "a_2_3", "a_3", "a_4", "a_2_2_2", "material"}));
}

TEST_F(ObjTest, WritesAnyNumberOfMaterialsThatShareAName)
{
    // If each looked for its number from the start, they would take hours.
    constexpr std::size_t kMaterials = 200'000;
    IndexedMesh mesh = sample_mesh();
    mesh.materials.assign(kMaterials, {"m", glm::vec4(0.5f), ""});
    write_mesh(file("a.obj"), mesh);
    const std::vector<std::string> names = new_materials(read_text(file("a.mtl")));
    ASSERT_EQ(names.size(), kMaterials);
    EXPECT_EQ(names.back(), "m_200000");
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), kMaterials);
}

}  // namespace
}  // namespace kerf::core::io
