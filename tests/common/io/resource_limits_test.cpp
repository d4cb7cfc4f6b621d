// A file that claims more than it has is refused before memory is taken for it.

#include <cstdint>
#include <string>
#include <vector>

#include "common/io/glb_sample.h"
#include "common/io/test_files.h"
#include "support/allocations.h"

namespace kerf::core::io {
namespace {

struct Claim
{
    std::string name;  ///< of the file
    std::string bytes;
    std::string reason;  ///< part of the message
};

constexpr std::uint32_t kBillions = 4'000'000'000u;

std::string little(std::uint32_t value)
{
    std::string bytes;
    store_little(bytes, value);
    return bytes;
}

std::string glb_with(const char* pointer, const nlohmann::json& value)
{
    nlohmann::json document = sample_document();
    document[nlohmann::json::json_pointer(pointer)] = value;
    return glb(document, sample_buffer());
}

std::string ply_with(const std::string& format, const std::string& vertices, const std::string& faces,
                     const std::string& data)
{
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + faces +
           "\nproperty list uint uint vertex_indices\nend_header\n" + data;
}

std::vector<Claim> claims()
{
    const std::string corner(12, '\0');
    const std::string chunk = "glTF" + little(2) + little(20 + 8) + little(kBillions) + "JSON" + "{}      ";
    return {
        {"vertices.off", "OFF\n4000000000 1 0\n0 0 0\n", "more than the file has room for"},
        {"faces.off", "OFF\n1 4000000000 0\n0 0 0\n3 0 0 0\n", "more than the file has room for"},
        {"corners.off", "OFF\n1 1 0\n0 0 0\n4000000000 0 0 0\n", "more than the file has room for"},
        {"text.ply", ply_with("ascii", "4000000000", "1", "0 0 0\n"), "more than the file has room for"},
        {"binary.ply", ply_with("binary_little_endian", "9223372036854775807", "1", corner), "room for"},
        {"faces.ply", ply_with("binary_big_endian", "1", "4000000000", corner), "room for"},
        {"corners.ply", ply_with("binary_little_endian", "1", "1", corner + little(kBillions) + little(0)),
         "truncated"},
        {"negative.ply", ply_with("ascii", "-1", "1", "0 0 0\n"), "negative"},
        {"triangles.stl", std::string(80, ' ') + little(kBillions) + std::string(50, '\0'), "truncated"},
        {"index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4000000000\n", "out of range"},
        {"huge_index.obj", "v 0 0 0\nf 1 1 99999999999999999999\n", "not an integer that fits"},
        {"accessor.glb", glb_with("/accessors/0/count", kBillions), "not inside its buffer view"},
        {"view.glb", glb_with("/bufferViews/0/byteLength", kBillions), "not inside its buffer"},
        {"buffer.glb", glb_with("/buffers/0/byteLength", kBillions), "truncated"},
        {"offset.glb", glb_with("/bufferViews/0/byteOffset", 0xFFFFFFFFFFFFFFFFu), "makes sense"},
        {"chunk.glb", chunk, "longer than the file"},
    };
}

using ResourceLimits = MeshFileTest;

TEST_F(ResourceLimits, AFileThatClaimsBillionsIsRefusedBeforeMemoryIsTaken)
{
    // Room for the file, for messages and for the parsed document of the samples.
    constexpr std::size_t kMostAtOnce = 1 << 16, kMostInAll = 1 << 20;
    for (const Claim& claim : claims()) {
        SCOPED_TRACE(claim.name);
        const std::filesystem::path path = write(claim.name, claim.bytes);
        test::reset_largest_allocation();
        const std::size_t before = test::allocated_bytes();
        const std::string error = error_of(path);
        EXPECT_LT(test::largest_allocation(), kMostAtOnce);
        EXPECT_LT(test::allocated_bytes() - before, kMostInAll);
        EXPECT_TRUE(contains(error, claim.reason)) << error;
    }
}

TEST_F(ResourceLimits, SparseListsThatShareTheirBytesAreBounded)
{
    // Two hundred lists of a hundred thousand values each, of which the file has one.
    constexpr std::size_t kValues = 100'000, kLists = 200;
    nlohmann::json document = sample_document();
    std::string buffer = sample_buffer() + std::string(kValues * 4, '\0');
    document["buffers"][0]["byteLength"] = buffer.size();
    document["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 92}, {"byteLength", kValues * 4}});
    nlohmann::json& primitives = document["meshes"][0]["primitives"];
    for (std::size_t i = 0; i < kLists; ++i) {
        document["accessors"].push_back({{"componentType", 5121},
                                         {"count", kValues},
                                         {"type", "VEC3"},
                                         {"sparse",
                                          {{"count", kValues},
                                           {"indices", {{"bufferView", 3}, {"componentType", 5121}}},
                                           {"values", {{"bufferView", 3}}}}}});
        primitives.push_back({{"attributes", {{"POSITION", 3 + i}}}, {"indices", 2}});
    }
    const std::filesystem::path path = write("a.glb", glb(document, buffer));
    const std::size_t before = test::allocated_bytes();
    EXPECT_TRUE(contains(error_of(path), "more values in all than it has bytes"));
    EXPECT_LT(test::allocated_bytes() - before, kLists * kValues * 16 / 4);
}

TEST_F(ResourceLimits, ABufferOfDecorationThatCannotBeReadIsTriedOnce)
{
    // A buffer whose last digit is none, and a thousand lists of normals in it.
    constexpr std::size_t kDigits = 400'000, kLists = 1000;
    nlohmann::json document = sample_document();
    document["buffers"].push_back({{"byteLength", 12}, {"uri", "data:;base64," + std::string(kDigits, 'A') + "*"}});
    document["bufferViews"].push_back({{"buffer", 1}, {"byteLength", 12}});
    nlohmann::json& primitives = document["meshes"][0]["primitives"];
    for (std::size_t i = 0; i < kLists; ++i) {
        document["accessors"].push_back({{"bufferView", 3}, {"componentType", 5126}, {"count", 1}, {"type", "VEC3"}});
        primitives.push_back({{"attributes", {{"POSITION", 0}, {"NORMAL", 3 + i}}}, {"indices", 2}});
    }
    const std::filesystem::path path = write("a.glb", glb(document, sample_buffer()));
    const std::size_t before = test::allocated_bytes();
    ReadingNotes notes;
    EXPECT_EQ(read_soup(path, &notes).triangles.size(), 2 * (kLists + 1));
    EXPECT_LT(test::allocated_bytes() - before, kDigits * 50);
    EXPECT_EQ(notes.describe(), "1000 lists of 'NORMAL' that cannot be read passed over");
}

TEST_F(ResourceLimits, MemoryShortWhileReadingIsAnErrorThatNamesTheFile)
{
    // Not glTF: nlohmann's JSON takes memory when it lets go of a document, and the program ends if there is none.
    for (const std::string extension : {"obj", "ply", "stl"}) {
        const std::filesystem::path path = file("a." + extension);
        write_mesh(path, sample_mesh());
        for (std::uint64_t number = 0;; ++number) {
            bool happened = false;
            std::string error;
            try {
                const test::FailingAllocation failure(number);
                try {
                    read_soup(path);
                } catch (const FileError& e) {
                    happened = failure.happened();
                    error = e.what();
                }
                if (!failure.happened()) break;
            } catch (const std::bad_alloc&) {
                ADD_FAILURE() << extension << ": allocation " << number << " left read_soup() as std::bad_alloc";
                break;
            }
            // A library that cannot be read for want of memory may be left out; then nothing is thrown.
            EXPECT_TRUE(!happened || contains(error, path.string() + ": ")) << error;
            ASSERT_LT(number, 100'000u);
        }
    }
}

}  // namespace
}  // namespace kerf::core::io
