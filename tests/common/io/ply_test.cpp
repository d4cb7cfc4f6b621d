#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/test_files.h"

namespace kerf::core::io {
namespace {

using PlyTest = MeshFileTest;

/// Bytes of numbers in either byte order.
class Binary
{
public:
    explicit Binary(Endian order) : order_(order) {}

    template <class T>
    Binary& operator<<(T value)
    {
        std::string bytes;
        store_little(bytes, value);
        if (order_ == Endian::big) std::reverse(bytes.begin(), bytes.end());
        bytes_ += bytes;
        return *this;
    }
    const std::string& bytes() const { return bytes_; }

private:
    Endian order_;
    std::string bytes_;
};

constexpr const char* kAsciiHead = "ply\nformat ascii 1.0\ncomment hello\nobj_info x\n";

TEST_F(PlyTest, PassesOverRemarksWithoutAKeywordBeforeTheElements)
{
    const auto file_with = [](const std::string& before, const std::string& behind) {
        return "ply\nformat ascii 1.0\n" + before + "element vertex 3\n" + behind +
               "property float x\nproperty float y\nproperty float z\nelement face 1\n"
               "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    };
    ReadingNotes notes;
    const TriangleSoup soup = read_soup(write("a.ply", file_with("Created by a program\n", "")), &notes);
    EXPECT_EQ(soup.triangles, (Buffer<Triangle>{{0, 1, 2}}));
    EXPECT_EQ(notes.describe(), "1 lines of the header that begin with no keyword passed over");
    // Its numbers would be taken for those of the next property.
    EXPECT_TRUE(contains(error_of("b.ply", file_with("", "proprety float quality\n")), "'proprety' is not a keyword"));
}

TEST_F(PlyTest, ReadsTextWithNormalsTextureCoordinatesColoursAndOtherProperties)
{
    const TriangleSoup soup = soup_of(
        "a.ply", std::string(kAsciiHead) +
                     "element vertex 3\nproperty double x\nproperty float y\nproperty float z\n"
                     "property float quality\nproperty float nx\nproperty float ny\nproperty float nz\n"
                     "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float u\n"
                     "property float v\nproperty int flags\nproperty float w_0\nproperty float w_1\n"
                     "element edge 1\nproperty int a\nproperty list uchar int b\n"
                     "element face 1\nproperty uchar m\nproperty list uchar int vertex_index\nproperty float q\n"
                     "end_header\n"
                     "1.00000005960464477539062500001 0 0 7 0 0 1 255 0 51 0.5 0.25 -3 1 2\n"
                     "1 0 0 8 0 0 1 0 0 0 0 0 4 3 4\n0 1 -0 9 0 0 1 0 0 0 0 0 5 5 6\n5 2 1 2\n0 3 0 1 2 0.5\n");
    ASSERT_EQ(soup.triangles, (Buffer<Triangle>{{0, 1, 2}}));
    EXPECT_EQ(soup.vertices[0].position.x, std::nextafter(1.0f, 2.0f)) << "straight to float, not through a double";
    EXPECT_EQ(soup.vertices[0].normal, glm::vec3(0, 0, 1));
    EXPECT_EQ(soup.vertices[0].uv, glm::vec2(0.5f, 0.25f));
    EXPECT_TRUE(soup.has_normals);
    ASSERT_EQ(soup.streams.size(), 4u);
    EXPECT_EQ(soup.streams[0].name, "quality");
    EXPECT_EQ(soup.streams[0].values, (Buffer<float>{7, 8, 9}));
    EXPECT_EQ(soup.streams[1].name, "color");
    EXPECT_EQ(soup.streams[1].values, (Buffer<float>{1, 0, 0.2f, 0, 0, 0, 0, 0, 0}));
    EXPECT_EQ(soup.streams[2].name, "flags");
    EXPECT_EQ(soup.streams[3].name, "w");
    EXPECT_EQ(soup.streams[3].width, 2u);
    EXPECT_EQ(soup.streams[3].values, (Buffer<float>{1, 2, 3, 4, 5, 6}));
}

TEST_F(PlyTest, ReadsBothByteOrdersAndAllTypes)
{
    for (const Endian order : {Endian::little, Endian::big}) {
        Binary body(order);
        // Faces first: the order of elements is free.
        body << std::uint16_t{4} << std::int16_t{0} << std::int16_t{1} << std::int16_t{2} << std::int16_t{3};
        for (int i = 0; i < 4; ++i)
            body << double{i == 1 || i == 2 ? 1.5 : 0.0} << float{i > 1 ? 0.1f : 0.0f} << std::int8_t{-1}
                 << std::uint32_t(4000000000u) << std::int32_t{-i} << std::uint16_t{65535};
        const TriangleSoup soup =
            soup_of("a.ply", "ply\r\nformat binary_" + std::string(order == Endian::little ? "little" : "big") +
                                 "_endian 1.0\r\nelement face 1\r\nproperty list ushort int16 vertex_indices\r\n"
                                 "element vertex 4\r\nproperty float64 x\r\nproperty float32 y\r\nproperty int8 z\r\n"
                                 "property uint32 big\r\nproperty int32 i\r\nproperty uint16 us\r\nend_header\r\n" +
                                 body.bytes());
        ASSERT_EQ(soup.triangles.size(), 2u);
        EXPECT_EQ(soup.vertices[2].position, glm::vec3(1.5f, 0.1f, -1.0f));
        ASSERT_EQ(soup.streams.size(), 3u);
        EXPECT_EQ(soup.streams[0].values[0], 4000000000.0f);
        EXPECT_EQ(soup.streams[1].values[3], -3.0f);
        EXPECT_EQ(soup.streams[2].values[0], 65535.0f);
    }
}

TEST_F(PlyTest, ReadsTriangleStrips)
{
    const TriangleSoup soup =
        soup_of("a.ply", std::string(kAsciiHead) +
                             "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
                             "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n");
    EXPECT_EQ(soup.triangles, (Buffer<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
}

TEST_F(PlyTest, ReadsBackBitForBitWhatItWrote)
{
    const IndexedMesh mesh = sample_mesh();
    write_mesh(file("a.ply"), mesh);
    const TriangleSoup soup = read_soup(file("a.ply"));
    EXPECT_EQ(soup.vertices.size(), mesh.vertices.size());
    EXPECT_EQ(soup.triangles, mesh.triangles);
    EXPECT_EQ(all_corners(soup), all_corners(mesh));
    ASSERT_EQ(soup.streams.size(), mesh.streams.size());
    for (std::size_t i = 0; i < mesh.streams.size(); ++i) {
        EXPECT_EQ(soup.streams[i].name, mesh.streams[i].name);
        EXPECT_EQ(soup.streams[i].width, mesh.streams[i].width);
    }
}

const std::string kVertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const std::string kFace = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

void expect_this_triangle(const TriangleSoup& soup, const std::string& what)
{
    ASSERT_EQ(soup.triangles, (Buffer<Triangle>{{0, 1, 2}})) << what;
    EXPECT_EQ(soup.vertices[1].position, glm::vec3(1, 0, 0)) << what;
    EXPECT_EQ(soup.vertices[2].position, glm::vec3(0, 1, 0)) << what;
}

TEST_F(PlyTest, TakesAttributesThatAreNotFiniteAsTextAndAsBinary)
{
    const std::string normals = "1 normals that are not finite numbers made anew";
    const std::string uvs = "1 texture coordinates that are not finite numbers set to 0";
    const std::string values = "1 values of further attributes that are not finite numbers set to 0";
    const std::vector<std::array<std::string, 3>> cases{
        {"nx ny nz", "nan nan nan", normals}, {"s t", "nan 0", uvs},        {"u v", "-1.#IND inf", uvs},
        {"quality", "nan", values},           {"quality", "1e300", values}, {"red green blue", "0 inf 0", values},
        {"nx ny nz", "1e300 0 0", normals},
    };
    for (const auto& [names, bad, notes] : cases) {
        std::string head = kVertex, zeros;
        std::istringstream words(names);
        std::size_t count = 0;
        for (std::string name; words >> name; ++count) {
            head += "property double " + name + "\n";
            zeros += "0 ";
        }
        const Read text = read("a.ply", kAsciiHead + head + kFace + "0 0 0 " + zeros + "\n1 0 0 " + bad + "\n0 1 0 " +
                                            zeros + "\n3 0 1 2\n");
        expect_this_triangle(text.soup, names);
        EXPECT_EQ(text.notes, notes) << names << " " << bad;

        Binary body(Endian::little);
        std::istringstream numbers(bad);
        for (int i = 0; i < 3; ++i) {
            body << float(i == 1) << float(i == 2) << 0.0f;
            for (std::size_t k = 0; k < count; ++k) body << (i == 1 ? std::numeric_limits<double>::infinity() : 0.0);
        }
        body << std::uint8_t{3} << std::int32_t{0} << std::int32_t{1} << std::int32_t{2};
        const Read binary = read("a.ply", "ply\nformat binary_little_endian 1.0\n" + head + kFace + body.bytes());
        expect_this_triangle(binary.soup, names);
        EXPECT_TRUE(contains(binary.notes, notes.substr(2))) << names << ": " << binary.notes;
    }
}

TEST_F(PlyTest, TakesAVertexOfNoFaceThatIsNotFiniteAsBinary)
{
    Binary body(Endian::little);
    for (int i = 0; i < 4; ++i) body << float(i == 1) << (i == 3 ? std::nanf("") : float(i == 2)) << 0.0f;
    body << std::uint8_t{3} << std::int32_t{0} << std::int32_t{1} << std::int32_t{2};
    std::string head = "ply\nformat binary_little_endian 1.0\n" + kVertex + kFace;
    head.replace(head.find("vertex 3"), 8, "vertex 4");
    const Read found = read("a.ply", head + body.bytes());
    expect_this_triangle(found.soup, "unused");
    EXPECT_EQ(found.notes, "1 vertices of no face that are not finite numbers passed over");
    std::string used = head + body.bytes();
    used[used.size() - 4] = 3;
    EXPECT_TRUE(
        contains(error_of("a.ply", used), "vertex 3 has a coordinate that is not finite or too large for single"));
}

TEST_F(PlyTest, TakesIndicesAndLengthsOfEveryTypeAndTheListByEachOfItsNames)
{
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    for (const char* name : {"vertex_indices", "vertex_index", "vertex_indexes"})
        for (const char* type : {"char", "uint16", "int64", "uint64", "float", "double"}) {
            const std::string face =
                "element face 1\nproperty list " + std::string(type) + " " + type + " " + name + "\nend_header\n";
            const Read text = read("a.ply", kAsciiHead + kVertex + face + points + "3 0 1 2\n");
            expect_this_triangle(text.soup, face);
            EXPECT_EQ(text.notes, "");
            const Read floats = read("a.ply", kAsciiHead + kVertex + face + points + "3.0 0.0 1e0 2\n");
            expect_this_triangle(floats.soup, face);
            EXPECT_EQ(floats.notes, "3 integers written with a point or an exponent read");

            for (const Endian order : {Endian::little, Endian::big}) {
                Binary body(order);
                for (int i = 0; i < 3; ++i) body << float(i == 1) << float(i == 2) << 0.0f;
                for (const int number : {3, 0, 1, 2}) {
                    if (type == std::string_view("char")) body << std::int8_t(number);
                    if (type == std::string_view("uint16")) body << std::uint16_t(number);
                    if (type == std::string_view("int64")) body << std::int64_t{number};
                    if (type == std::string_view("uint64")) body << std::uint64_t(number);
                    if (type == std::string_view("float")) body << float(number);
                    if (type == std::string_view("double")) body << double(number);
                }
                const std::string head =
                    "ply\nformat binary_" + std::string(order == Endian::little ? "little" : "big") + "_endian 1.0\n";
                const Read binary = read("a.ply", head + kVertex + face + body.bytes());
                expect_this_triangle(binary.soup, face);
                const bool is_float = type == std::string_view("float") || type == std::string_view("double");
                EXPECT_EQ(binary.notes, is_float ? "4 integers stored as floating point read" : "");
            }
        }
}

TEST_F(PlyTest, RefusesFloatsThatAreNoIndices)
{
    for (const double bad : {0.5, -1.0, 3.0, 1e300, std::nan(""), std::numeric_limits<double>::infinity()}) {
        Binary body(Endian::little);
        for (int i = 0; i < 9; ++i) body << float(i);
        body << std::uint8_t{3} << 0.0 << 1.0 << bad;
        const std::string error = error_of("a.ply", "ply\nformat binary_little_endian 1.0\n" + kVertex +
                                                        "element face 1\nproperty list uchar double vertex_indices\n"
                                                        "end_header\n" +
                                                        body.bytes());
        EXPECT_TRUE(contains(error, "not a whole number") || contains(error, "out of range")) << error;
    }
    Binary body(Endian::little);
    for (int i = 0; i < 9; ++i) body << float(i);
    body << std::uint64_t{0xFFFFFFFFFFFFFFFFu};
    EXPECT_TRUE(contains(
        error_of("a.ply", "ply\nformat binary_little_endian 1.0\n" + kVertex +
                              "element face 1\nproperty list uint64 int vertex_indices\nend_header\n" + body.bytes()),
        "truncated"));
}

TEST_F(PlyTest, ReadsSixtyFourBitNumbersOfVertices)
{
    const TriangleSoup soup = soup_of("a.ply", kAsciiHead + kVertex + "property int64 a\nproperty uint64 b\n" + kFace +
                                                   "0 0 0 -5 18446744073709551615\n1 0 0 0 0\n0 1 0 0 0\n3 0 1 2\n");
    expect_this_triangle(soup, "text");
    EXPECT_EQ(soup.streams.at(0).values[0], -5.0f);
    Binary body(Endian::big);
    for (int i = 0; i < 3; ++i)
        body << float(i == 1) << float(i == 2) << 0.0f << std::int64_t{-5} << std::uint64_t{0xFFFFFFFFFFFFFFFFu};
    body << std::uint8_t{3} << std::int32_t{0} << std::int32_t{1} << std::int32_t{2};
    const TriangleSoup binary = soup_of("a.ply", "ply\nformat binary_big_endian 1.0\n" + kVertex +
                                                     "property int64 a\nproperty uint64 b\n" + kFace + body.bytes());
    expect_this_triangle(binary, "binary");
    EXPECT_EQ(binary.streams.at(0).values[0], -5.0f);
    EXPECT_EQ(binary.streams.at(1).values[0], 18446744073709551616.0f) << "not cut off at the largest signed integer";
}

TEST_F(PlyTest, PassesOverFurtherNumbersAtTheEndsOfLines)
{
    const std::string longer = " lines with more numbers than they need read without them";
    const std::string head = kAsciiHead + kVertex + kFace;
    const Read every = read("a.ply", head + "0 0 0 9\n1 0 0 9 9\n0 1 0 # x\n\n3 0 1 2 255 0 0\n");
    expect_this_triangle(every.soup, "every line");
    EXPECT_EQ(every.notes, "4" + longer);
    const Read one = read("a.ply", head + "0 0 0\n1 0 0 9\n0 1 0\n3 0 1 2");
    expect_this_triangle(one.soup, "one line");
    EXPECT_EQ(one.notes, "1" + longer);
}

TEST_F(PlyTest, TakesAttributesOfTextThatAreNoNumbersOrMissing)
{
    const std::string bad_values = " values of further attributes that are not finite numbers set to 0";
    const std::string bad_uvs = " texture coordinates that are not finite numbers set to 0";
    const std::string shorter = " lines with fewer numbers than the header promises read without them";
    const std::string colour = "property uchar red\nproperty uchar green\nproperty uchar blue\n";
    const std::string weights = "property list uchar float weights\n";
    const std::vector<std::array<std::string, 3>> cases{
        {"property float quality\n", "0,5", "3" + bad_values},
        {"property float quality\n", "-", "3" + bad_values},
        {"property float quality\n", "", "3" + shorter + ", 3" + bad_values},
        {colour, "-1 300 x", "3" + bad_values},
        {colour, "255", "3" + shorter + ", 6" + bad_values},
        {"property float s\nproperty float t\n", "0.5 x", "3" + bad_uvs},
        {weights, "3 0.5 x 1", ""},
        {weights, "3 0.5", "3" + shorter},
        {weights, "", "3" + shorter},
        {weights + "property float quality\n", "3 0.5", "3" + shorter + ", 3" + bad_values},
    };
    for (const auto& [properties, data, notes] : cases) {
        const Read found = read("a.ply", kAsciiHead + kVertex + properties + kFace + "0 0 0 " + data + "\n1 0 0 " +
                                             data + "\n0 1 0 " + data + "\n3 0 1 2\n");
        expect_this_triangle(found.soup, properties + data);
        EXPECT_EQ(found.notes, notes) << properties << data;
    }
    const std::string face =
        "element face 1\nproperty list uchar int vertex_indices\nproperty list uchar float "
        "texcoord\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 6 0 0 1 0\n";
    const Read found = read("a.ply", kAsciiHead + kVertex + face);
    expect_this_triangle(found.soup, "texcoord");
    EXPECT_EQ(found.notes, "1" + shorter);
    // Where lines are no elements, a number that is missing is one of those that follow.
    EXPECT_TRUE(contains(error_of("a.ply", kAsciiHead + kVertex + "property float quality\n" + kFace +
                                               "0 0 0 1 1 0 0 1\n0 1 0 3 0 1 2\n"),
                         "stands behind the last number"));
}

TEST_F(PlyTest, TakesTypesOfTextThatItDoesNotKnowAsNumbers)
{
    const std::string face = "element face 1\nproperty list byte index vertex_indices\nend_header\n";
    const std::string unknown = " types of properties that PLY does not have taken as numbers";
    const auto file = [&](const std::string& format, const std::string& xyz) {
        return "ply\n" + format + "element vertex 3\n" + xyz + "property half q\n" + face +
               "0 0 0 7\n1 0 0 0.5\n0 1 0 x\n3 0 1 2\n";
    };
    const std::string xyz = "property float x\nproperty float y\nproperty real z\n", ascii = "format ascii 1.0\n";
    const Read found = read("a.ply", file(ascii, xyz));
    EXPECT_EQ(found.soup.triangles, (Buffer<Triangle>{{0, 1, 2}}));
    EXPECT_EQ(found.soup.streams.at(0).values, (Buffer<float>{7, 0.5, 0}));
    EXPECT_TRUE(contains(found.notes, "4" + unknown)) << found.notes;
    EXPECT_TRUE(contains(error_of("a.ply", file("format binary_little_endian 1.0\n", xyz)), "'real' is not a type"));
    EXPECT_TRUE(contains(error_of("a.ply", file("", xyz)), "'real' is not a type"));
    EXPECT_TRUE(contains(error_of("a.ply", file(ascii, xyz + "format binary_big_endian 1.0\n")), "a second format"));
    // Nobody knows which of the two is meant.
    EXPECT_TRUE(contains(error_of("a.ply", file(ascii, xyz + "property float x\n")), "more than one property 'x'"));
}

TEST_F(PlyTest, TakesItsFirstWordInCapitals)
{
    const Read found = read("a.ply", "PLY\nformat ascii 1.0\n" + kVertex + kFace + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
    expect_this_triangle(found.soup, "capitals");
    EXPECT_EQ(found.notes, "1 header that begins with PLY in capitals read");
}

TEST_F(PlyTest, TakesElementsThatShareLinesOrTakeSeveral)
{
    for (const char* body : {"0 0 0 1 0 0 0 1 0 3 0 1 2", "0 0 0 1 0 0 0 1 0\n3 0 1 2\n", "0 0 0 1 0 0\n0 1 0 3\n0 1 2",
                             "0 0\n0\n1 0 0\n0\n\n1 0\n3\n0 1 2\n", "0\r\n0\r\n0 1 0 0 0 1 0 3 0 1 2"}) {
        const Read found = read("a.ply", kAsciiHead + kVertex + kFace + body);
        expect_this_triangle(found.soup, body);
        EXPECT_EQ(found.notes, "") << body;
    }
}

TEST_F(PlyTest, TakesElementsOfSeveralLinesBesideLinesThatAreTooLong)
{
    const std::string longer = " lines with more numbers than they need read without them";
    const std::string behind = "1 lines behind the last one that is expected passed over";
    const std::string plain = kAsciiHead + kVertex + kFace;
    const std::string normals =
        kAsciiHead + kVertex + "property float nx\nproperty float ny\nproperty float nz\n" + kFace;
    const std::vector<std::array<std::string, 3>> cases{
        {plain, "0 0 0 9\n1 0\n0\n0 1 0\n3 0 1 2\n", "1" + longer},
        {plain, "0 0 0\n1 0\n0\n0 1 0 9\n3 0 1 2\n", "1" + longer},
        {plain, "0 0\n0\n1 0 0 9\n0\n1\n\n0\n3 0 1 2 9\n", "2" + longer},
        {plain, "0 0 0 9\n1 0 0\n0 1 0 9\n3\n0 1\n2\n", "2" + longer},
        {plain, "0 0\n0\n1 0 0 9\n0 1 0\n3 0 1 2\nx\n", behind + ", 1" + longer},
        {normals, "0 0 0 0 0 1 9\n1 0 0\n0 0 1\n0 1 0\n0 0 1\n3 0 1 2\n", "1" + longer},
    };
    for (const auto& [head, body, notes] : cases) {
        const Read found = read("a.ply", head + body);
        expect_this_triangle(found.soup, body);
        EXPECT_EQ(found.notes, notes) << body;
        EXPECT_EQ(found.soup.has_normals, head == normals) << body;
    }
    // One that goes on in a line that is too long is rather too short itself.
    EXPECT_TRUE(contains(error_of("a.ply", plain + "0 0 0 9\n1 0\n0 9\n0 1 0\n3 0 1 2\n"),
                         "line 13: it has fewer numbers than the header promises"));
    EXPECT_TRUE(contains(error_of("a.ply", normals + "0 0 0 0 0 1 9\n1 0 0\n0 1 0 0 0 1\n3 0 1 2\nx\n"),
                         "line 16: it has fewer numbers than the header promises"));
}

TEST_F(PlyTest, TakesElementsOfSeveralLinesBesideOnesThatShareALine)
{
    const std::string quality = "property float quality\n";
    const std::string two = std::string(kFace).replace(kFace.find("face 1"), 6, "face 2");
    const std::string faces = "3 0 1 2 3 0 1 2\n";
    const std::vector<std::pair<std::string, std::string>> cases{
        // As many lines as elements, but none of them has one of its own.
        {two, "0 0\n0\n1 0 0\n0 1 0\n" + faces},
        {two, "0 0 0 1 0 0\n0 1 0\n3 0\n1 2\n3 0 1 2\n"},
        {quality + two, "0 0 0\n1\n1 0 0 1\n0 1 0 1\n" + faces},
        // More lines than elements at the beginning, and fewer behind.
        {two, "0 0\n0\n1 0\n0\n0 1 0\n" + faces},
        {two, "0 0 0 1 0 0\n0 1\n0\n3 0 1\n2\n3 0 1 2"},
    };
    for (const auto& [header, body] : cases) {
        const Read found = read("a.ply", kAsciiHead + kVertex + header + body);
        ASSERT_EQ(found.soup.triangles.size(), 2u) << body;
        for (const Triangle& triangle : found.soup.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_EQ(found.soup.vertices[triangle[k]].position, glm::vec3(k == 1, k == 2, 0)) << body;
        EXPECT_EQ(found.notes, "") << body;
    }
    // A line too short before one that is too long by as much is a fault, and is named.
    EXPECT_TRUE(contains(error_of("a.ply", kAsciiHead + kVertex + two + "0 0\n1 0 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n"),
                         "line 12: a coordinate is missing"));
    // Where elements would begin within lines and go on in others, lines are elements.
    const Read short_and_long =
        read("a.ply", kAsciiHead + kVertex + quality + kFace + "0 0 0\n1 0 0 1 9\n0 1 0 1\n3 0 1 2\n");
    expect_this_triangle(short_and_long.soup, "short and long");
    EXPECT_TRUE(contains(short_and_long.notes, "1 lines with fewer numbers") &&
                contains(short_and_long.notes, "1 lines with more numbers"))
        << short_and_long.notes;
}

TEST_F(PlyTest, NamesTheLineThatIsTooShort)
{
    const std::string head = kAsciiHead + kVertex + kFace;  // 11 lines
    const std::string coordinate = "a coordinate is missing", index = "a vertex index is missing";
    EXPECT_TRUE(contains(error_of("a.ply", head + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "line 12: " + coordinate));
    EXPECT_TRUE(contains(error_of("a.ply", head + "0 0 0\n1 0 0\n\n0\n3 0 1 2\n"), "line 15: " + coordinate));
    EXPECT_TRUE(contains(error_of("a.ply", head + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n"), "line 15: " + index));
    const std::string two = std::string(head).replace(head.find("face 1"), 6, "face 2");
    for (const char* face : {"3 0 1", "4 0 1 2"})
        EXPECT_TRUE(contains(error_of("a.ply", two + "0 0 0\n1 0 0\n0 1 0\n" + face + "\n3 0 1 2\n"),
                             "line 15: " + index + "; "))
            << face;
    // With more lines than that, it might have gone on in the next one; but that one has too many numbers then.
    const std::string shorter = "it has fewer numbers than the header promises; complete it";
    EXPECT_TRUE(contains(error_of("a.ply", head + "0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 2 1\n"), "line 12: " + shorter));
    EXPECT_TRUE(contains(error_of("a.ply", two + "0 0 0\n1 0 0\n0 1 0\n3 0 1\n3 0 1 2\n3 0 2 1\n"),
                         "line 16: vertex 3 is out of range: there are 3, counted from 0; mend the face or take it out "
                         "(read as going on from line 15: that one may be too short)"));
    // Fewer lines are what a file has that is cut off.
    EXPECT_TRUE(contains(error_of("a.ply", two + "0 0 0\n1 0 0\n0 1 0\n3 0"), "there are fewer lines than vertices"));
}

TEST_F(PlyTest, NotesLinesBehindTheLastFace)
{
    const Read found = read("a.ply", kAsciiHead + kVertex + kFace + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n\n3 0 2 1\nx\n");
    expect_this_triangle(found.soup, "more");
    EXPECT_EQ(found.notes, "2 lines behind the last one that is expected passed over");
}

TEST_F(PlyTest, ReadsBinaryNumbersBehindEveryLineEnd)
{
    // The first byte is a line feed: behind a header of lines that end with CR it belongs to the numbers.
    for (const char* end : {"\n", "\r\n", "\r"}) {
        std::string head = "ply\nformat binary_big_endian 1.0\n" + kVertex + kFace;
        for (std::size_t at = 0; (at = head.find('\n', at)) != std::string::npos; at += std::string(end).size())
            head.replace(at, 1, end);
        Binary body(Endian::big);
        body << std::bit_cast<float>(0x0A000000u);
        for (int i = 1; i < 9; ++i) body << float(i == 3 || i == 7);
        body << std::uint8_t{3} << std::int32_t{0} << std::int32_t{1} << std::int32_t{2};
        expect_this_triangle(soup_of("a.ply", head + body.bytes()), end);
    }
}

TEST_F(PlyTest, NotesBytesBehindTheLastElementOfABinaryFile)
{
    Binary body(Endian::little);
    for (int i = 0; i < 9; ++i) body << float(i == 3 || i == 7);
    body << std::uint8_t{3} << std::int32_t{0} << std::int32_t{1} << std::int32_t{2};
    const std::string head = "ply\nformat binary_little_endian 1.0\n" + kVertex + kFace;
    EXPECT_EQ(read("a.ply", head + body.bytes()).notes, "");
    EXPECT_EQ(read("a.ply", head + body.bytes() + "more").notes, "4 bytes behind the end passed over");
}

TEST_F(PlyTest, PassesOverFacesThatBoundNothingAndListsOfVertices)
{
    const Read found = read("a.ply", kAsciiHead + kVertex + "property list uchar float weights\n" +
                                         "element face 4\nproperty list uchar int vertex_indices\nend_header\n"
                                         "0 0 0 2 1 1\n1 0 0 0\n0 1 0 1 7\n0\n1 0\n2 0 1\n3 0 1 2\n");
    expect_this_triangle(found.soup, "lists");
    EXPECT_EQ(found.notes, "3 faces of fewer than three corners passed over");
}

TEST_F(PlyTest, SaysWhatIsWrong)
{
    const std::string vertex = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const std::string face = "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    const std::string ascii = kAsciiHead + vertex + face + points;
    EXPECT_TRUE(contains(error_of("a.ply", ascii + "3 0 1 3\n"), "line 15: vertex 3 is out of range"));
    EXPECT_TRUE(contains(error_of("a.ply", ascii + "3 0 1 -1\n"), "out of range"));
    EXPECT_TRUE(contains(error_of("a.ply", ascii + "3 0 1\n"), "missing"));
    EXPECT_TRUE(contains(error_of("a.ply", ascii + "-1 0 1\n"), "negative length"));
    EXPECT_TRUE(contains(error_of("a.ply", ascii + "0\n"), "no triangles"));
    EXPECT_TRUE(
        contains(error_of("a.ply", kAsciiHead + vertex + face + "0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n"), "not finite"));
    EXPECT_TRUE(contains(error_of("a.ply", "ply\nformat ascii 2.0"), "ends inside the header"));
    EXPECT_TRUE(contains(error_of("a.ply", "ply\nformat text 1.0\n"), "not a format"));
    EXPECT_TRUE(contains(error_of("a.ply", "plx\n"), "does not begin"));
    EXPECT_TRUE(contains(error_of("a.ply", "ply\nend_header\n"), "does not name the format"));
    EXPECT_TRUE(
        contains(error_of("a.ply", std::string(kAsciiHead) + "property float x\n"), "before the first element"));
    EXPECT_TRUE(contains(error_of("a.ply", std::string(kAsciiHead) + "element vertex 1\nproperty\n"), "not a type"));
    EXPECT_TRUE(contains(
        error_of("a.ply", std::string(kAsciiHead) + "element vertex 1\nproperty float x\n" + face + "1\n3 0 0 0\n"),
        "no x, y and z"));
    EXPECT_TRUE(
        contains(error_of("a.ply", std::string(kAsciiHead) + vertex + vertex + face + points + points + "3 0 1 2"),
                 "more than one"));
    EXPECT_TRUE(contains(error_of("a.ply", kAsciiHead + vertex + "element face 1\nproperty list uchar int corners\n" +
                                               "end_header\n" + points + "3 0 1 2"),
                         "its faces have no list 'vertex_indices'"));
    EXPECT_TRUE(contains(error_of("a.ply", kAsciiHead + vertex + "end_header\n" + points), "no triangles"));
    EXPECT_TRUE(contains(
        error_of("a.ply",
                 kAsciiHead + vertex + "property list uchar uint vertex_indices\nend_header\n" + points + "3 0 1 2"),
        "corners of faces among the properties of vertices"));
    EXPECT_TRUE(
        contains(error_of("a.ply", ascii + "3.5 0 1 2"), "the length of a list is '3.5', which is not an integer"));
    EXPECT_TRUE(contains(error_of("a.ply", ascii + "3 0 x 2"), "a vertex index is 'x', which is not an integer"));
    EXPECT_TRUE(contains(error_of("a.ply", kAsciiHead + vertex + face + "0 0 0\n1 0 0\n0 x 0\n3 0 1 2\n"),
                         "line 14: a coordinate is 'x', which is not a number"));
}

TEST_F(PlyTest, RefusesCountsThatTheFileHasNoRoomForBeforeTakingMemory)
{
    for (const char* format : {"ascii", "binary_little_endian"})
        for (const char* count : {"4000000000", "9223372036854775807"}) {
            const std::string head = "ply\nformat " + std::string(format) + " 1.0\n";
            EXPECT_TRUE(contains(error_of("a.ply", head + "element vertex " + count +
                                                       "\nproperty float x\nproperty float y\nproperty float z\n"
                                                       "end_header\n0 0 0\n"),
                                 "more than the file has room for"));
        }
    Binary body(Endian::little);
    body << 0.0f << 0.0f << 0.0f << 4000000000u << std::int32_t{0};
    EXPECT_TRUE(contains(error_of("a.ply",
                                  "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
                                  "property float y\nproperty float z\nelement face 1\n"
                                  "property list uint int vertex_indices\nend_header\n" +
                                      body.bytes()),
                         "truncated"));
}

}  // namespace
}  // namespace kerf::core::io
