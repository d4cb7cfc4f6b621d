#include <algorithm>
#include <bit>
#include <cmath>

#include "common/io/bytes.h"
#include "io/test_files.h"

namespace kerf::io {
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
    EXPECT_TRUE(
        contains(error_of("a.ply", std::string(kAsciiHead) + "element vertex 1\nproperty quad x\n"), "not a type"));
    EXPECT_TRUE(contains(
        error_of("a.ply", std::string(kAsciiHead) + "element vertex 1\nproperty float x\n" + face + "1\n3 0 0 0\n"),
        "no x, y and z"));
    EXPECT_TRUE(
        contains(error_of("a.ply", std::string(kAsciiHead) + vertex + vertex + face + points + points + "3 0 1 2"),
                 "more than one"));
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
}  // namespace kerf::io
