#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/glb_sample.h"
#include "common/io/test_files.h"

// Ways in which a glTF file may hold its surface: integers, sparse lists, copies in many places. What comes out is
// written down here by hand, from the extensions' texts.

namespace kerf::core::io {
namespace {

using nlohmann::json;

class GltfGeometryTest : public MeshFileTest
{
protected:
    TriangleSoup soup() const { return soup_of("a.glb", glb(document_, buffer_)); }
    std::string error() const { return error_of("a.glb", glb(document_, buffer_)); }

    /// Gives the triangles' vertices an attribute; numbers beyond `values` are 0.
    template <class T>
    json& set(const char* name, int component, const char* type, std::size_t width, std::vector<T> values,
              bool is_normalized)
    {
        values.resize(4 * width);
        const std::size_t index = add_accessor(document_, buffer_, component, type, 4, values);
        primitive_of(document_)["attributes"][name] = index;
        json& accessor = document_["accessors"][index];
        if (is_normalized) accessor["normalized"] = true;
        return accessor;
    }

    json document_ = sample_document();
    std::string buffer_ = sample_buffer();
};

TEST_F(GltfGeometryTest, QuantizedPositionsAreReadInEveryType)
{
    document_["extensionsRequired"] = {"KHR_mesh_quantization"};
    const auto second = [&] { return soup().vertices.at(1).position; };
    set("POSITION", 5120, "VEC3", 3, std::vector<std::int8_t>{0, 0, 0, 127, -128, 1}, false);
    EXPECT_EQ(second(), glm::vec3(127.0f, -128.0f, 1.0f));
    set("POSITION", 5120, "VEC3", 3, std::vector<std::int8_t>{0, 0, 0, 127, -128, -127}, true);
    EXPECT_EQ(second(), glm::vec3(1.0f, -1.0f, -1.0f));
    set("POSITION", 5121, "VEC3", 3, std::vector<std::uint8_t>{0, 0, 0, 255, 51, 1}, false);
    EXPECT_EQ(second(), glm::vec3(255.0f, 51.0f, 1.0f));
    set("POSITION", 5121, "VEC3", 3, std::vector<std::uint8_t>{0, 0, 0, 255, 51, 0}, true);
    EXPECT_EQ(second(), glm::vec3(1.0f, 0.2f, 0.0f));
    set("POSITION", 5122, "VEC3", 3, std::vector<std::int16_t>{0, 0, 0, 32767, -32768, 7}, false);
    EXPECT_EQ(second(), glm::vec3(32767.0f, -32768.0f, 7.0f));
    set("POSITION", 5122, "VEC3", 3, std::vector<std::int16_t>{0, 0, 0, 32767, -32768, -32767}, true);
    EXPECT_EQ(second(), glm::vec3(1.0f, -1.0f, -1.0f));
    set("POSITION", 5123, "VEC3", 3, std::vector<std::uint16_t>{0, 0, 0, 65535, 13107, 7}, false);
    EXPECT_EQ(second(), glm::vec3(65535.0f, 13107.0f, 7.0f));
    set("POSITION", 5123, "VEC3", 3, std::vector<std::uint16_t>{0, 0, 0, 65535, 13107, 0}, true);
    EXPECT_EQ(second(), glm::vec3(1.0f, 0.2f, 0.0f));
}

TEST_F(GltfGeometryTest, QuantizedPositionsAreScaledByTheirNode)
{
    // As gltfpack writes them: 16 bits, a stride of eight, a scale and an offset on the node.
    document_["extensionsRequired"] = {"KHR_mesh_quantization"};
    std::vector<std::uint16_t> values;
    for (const int v : {0, 0, 0, 7, 16383, 0, 0, 7, 16383, 16383, 0, 7, 0, 16383, 0, 7})
        values.push_back(static_cast<std::uint16_t>(v));
    const std::size_t index = add_accessor(document_, buffer_, 5123, "VEC3", 4, values);
    document_["bufferViews"].back()["byteStride"] = 8;
    primitive_of(document_)["attributes"]["POSITION"] = index;
    document_["nodes"][0]["scale"] = {2.0 / 16383, 2.0 / 16383, 2.0 / 16383};
    document_["nodes"][0]["translation"] = {-1, -1, 0.5};
    const TriangleSoup read = soup();
    EXPECT_EQ(read.vertices[0].position, glm::vec3(-1.0f, -1.0f, 0.5f));
    EXPECT_EQ(read.vertices[1].position, glm::vec3(1.0f, -1.0f, 0.5f));
    EXPECT_EQ(read.vertices[2].position, glm::vec3(1.0f, 1.0f, 0.5f));
    EXPECT_EQ(read.triangles, (Buffer<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(GltfGeometryTest, QuantizedNormalsAreUnitVectors)
{
    document_["extensionsRequired"] = {"KHR_mesh_quantization"};
    const auto first = [&] { return soup().vertices.at(0).normal; };
    set("NORMAL", 5120, "VEC3", 3, std::vector<std::int8_t>{0, -127, 0}, true);
    EXPECT_EQ(first(), glm::vec3(0.0f, -1.0f, 0.0f));
    set("NORMAL", 5122, "VEC3", 3, std::vector<std::int16_t>{19660, 0, 26214}, true);
    EXPECT_NEAR(first().x, 0.6f, 1e-4f);
    EXPECT_NEAR(glm::length(first()), 1.0f, 1e-6f);
    set("NORMAL", 5120, "VEC3", 3, std::vector<std::int8_t>{0, 0, 90}, false);
    EXPECT_EQ(first(), glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST_F(GltfGeometryTest, QuantizedTextureCoordinatesAreReadInEveryType)
{
    document_["extensionsRequired"] = {"KHR_mesh_quantization"};
    // With the origin in the lower left corner, as everywhere in the library.
    const auto first = [&] { return soup().vertices.at(0).uv; };
    set("TEXCOORD_0", 5120, "VEC2", 2, std::vector<std::int8_t>{127, -128}, false);
    EXPECT_EQ(first(), glm::vec2(127.0f, 129.0f));
    set("TEXCOORD_0", 5120, "VEC2", 2, std::vector<std::int8_t>{127, -127}, true);
    EXPECT_EQ(first(), glm::vec2(1.0f, 2.0f));
    set("TEXCOORD_0", 5121, "VEC2", 2, std::vector<std::uint8_t>{255, 2}, false);
    EXPECT_EQ(first(), glm::vec2(255.0f, -1.0f));
    set("TEXCOORD_0", 5121, "VEC2", 2, std::vector<std::uint8_t>{51, 255}, true);
    EXPECT_EQ(first(), glm::vec2(0.2f, 0.0f));
    set("TEXCOORD_0", 5122, "VEC2", 2, std::vector<std::int16_t>{-300, 300}, false);
    EXPECT_EQ(first(), glm::vec2(-300.0f, -299.0f));
    set("TEXCOORD_0", 5122, "VEC2", 2, std::vector<std::int16_t>{-32767, 32767}, true);
    EXPECT_EQ(first(), glm::vec2(-1.0f, 0.0f));
    set("TEXCOORD_0", 5123, "VEC2", 2, std::vector<std::uint16_t>{4095, 1}, false);
    EXPECT_EQ(first(), glm::vec2(4095.0f, 0.0f));
    set("TEXCOORD_0", 5123, "VEC2", 2, std::vector<std::uint16_t>{13107, 65535}, true);
    EXPECT_EQ(first(), glm::vec2(0.2f, 0.0f));
}

TEST_F(GltfGeometryTest, TextureTransformsAreApplied)
{
    json& use = document_["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"];
    use["extensions"]["KHR_texture_transform"] = {
        {"offset", {0, 1}}, {"rotation", std::acos(0.0)}, {"scale", {0.5, 0.5}}};
    set("TEXCOORD_0", 5126, "VEC2", 2, std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, false);
    const auto expect = [&](std::size_t vertex, float u, float v) {
        const glm::vec2 uv = soup().vertices.at(vertex).uv;
        EXPECT_NEAR(uv.x, u, 1e-6f) << vertex;
        EXPECT_NEAR(uv.y, 1.0f - v, 1e-6f) << vertex;
    };
    // The extension's own example: the lower left quarter of the picture, turned clockwise by a quarter turn.
    expect(0, 0.0f, 1.0f);
    expect(1, 0.0f, 0.5f);
    expect(2, 0.5f, 0.5f);
    expect(3, 0.5f, 1.0f);

    // Quantized by 4095, and the texture goes by the second set.
    set("TEXCOORD_1", 5123, "VEC2", 2, std::vector<std::uint16_t>{0, 0, 4095, 0, 4095, 4095}, false);
    use["texCoord"] = 1;
    use["extensions"]["KHR_texture_transform"] = {{"scale", {1.0 / 4095, 1.0 / 4095}}};
    const TriangleSoup read = soup();
    EXPECT_EQ(read.vertices[2].uv, glm::vec2(1.0f, 0.0f)) << "of the first set";
    EXPECT_EQ(read.streams.at(0).name, "uv1");
    EXPECT_FLOAT_EQ(read.streams[0].values[2], 1.0f);
    EXPECT_FLOAT_EQ(read.streams[0].values[3], 1.0f);
    EXPECT_NEAR(read.streams[0].values[5], 0.0f, 1e-6f);

    // What makes no sense is as if it were not there.
    use["texCoord"] = 0;
    use["extensions"]["KHR_texture_transform"] = {{"scale", {1}}, {"offset", "none"}, {"rotation", nullptr}};
    EXPECT_EQ(soup().vertices[2].uv, glm::vec2(1.0f, 0.0f));
}

TEST_F(GltfGeometryTest, InstancesBecomeCopiesWithTheirTransforms)
{
    const double half = std::sqrt(0.5);
    const auto h = static_cast<float>(half);
    const std::size_t translation =
        add_accessor(document_, buffer_, 5126, "VEC3", 3, std::vector<float>{0, 0, 0, 10, 0, 0, 0, 20, 0});
    const std::size_t rotation =
        add_accessor(document_, buffer_, 5126, "VEC4", 3, std::vector<float>{0, 0, 0, 1, 0, 0, h, h, 0, 0, 0, 1});
    const std::size_t scale =
        add_accessor(document_, buffer_, 5126, "VEC3", 3, std::vector<float>{1, 1, 1, 2, 2, 2, -1, 1, 1});
    document_["nodes"][0]["translation"] = {0, 0, 100};
    document_["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {
        {"TRANSLATION", translation}, {"ROTATION", rotation}, {"SCALE", scale}, {"_ID", 9}};
    for (const bool is_required : {false, true}) {
        if (is_required) document_["extensionsRequired"] = {"EXT_mesh_gpu_instancing"};
        const TriangleSoup read = soup();
        ASSERT_EQ(read.triangles.size(), 6u);
        ASSERT_EQ(read.vertices.size(), 12u);
        // The corner (1, 1, 0): as it is; doubled, turned by a quarter and moved along x; mirrored and moved along y.
        EXPECT_EQ(read.vertices[2].position, glm::vec3(1.0f, 1.0f, 100.0f));
        EXPECT_NEAR(read.vertices[6].position.x, 8.0f, 1e-6f);
        EXPECT_NEAR(read.vertices[6].position.y, 2.0f, 1e-6f);
        EXPECT_EQ(read.vertices[6].position.z, 100.0f);
        EXPECT_EQ(read.vertices[10].position, glm::vec3(-1.0f, 21.0f, 100.0f));
        EXPECT_EQ(read.triangles[0], (Triangle{0, 1, 2}));
        EXPECT_EQ(read.triangles[2], (Triangle{4, 5, 6}));
        EXPECT_EQ(read.triangles[4], (Triangle{10, 9, 8})) << "a mirrored copy must turn over";
    }
}

TEST_F(GltfGeometryTest, InstancesMayBeTurnedByIntegers)
{
    const std::size_t rotation =
        add_accessor(document_, buffer_, 5122, "VEC4", 1, std::vector<std::int16_t>{0, 0, 32767, 0});
    document_["accessors"][rotation]["normalized"] = true;
    document_["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = {{"ROTATION", rotation}};
    EXPECT_EQ(soup().vertices[2].position, glm::vec3(-1.0f, -1.0f, 0.0f)) << "half a turn around z";
}

TEST_F(GltfGeometryTest, InstancesThatMakeNoSenseAreRefused)
{
    json& attributes = document_["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"];
    const std::size_t three = add_accessor(document_, buffer_, 5126, "VEC3", 3, std::vector<float>(9));
    const std::size_t two = add_accessor(document_, buffer_, 5126, "VEC3", 2, std::vector<float>(6));
    attributes = {{"TRANSLATION", three}, {"SCALE", two}};
    EXPECT_TRUE(contains(error(), "2 values in 'SCALE', but 3 in another list")) << error();
    attributes = {{"ROTATION", three}};
    EXPECT_TRUE(contains(error(), "'ROTATION' of the instances of node 0 does not have 4 numbers"));
}

TEST_F(GltfGeometryTest, CopiesAreBoundedByTheSizeOfTheFile)
{
    // A list without bytes of its own is zeros, however long it says that it is.
    document_["accessors"].push_back({{"componentType", 5126}, {"count", 1'000'000'000'000}, {"type", "VEC3"}});
    json& extensions = document_["nodes"][0]["extensions"];
    extensions["EXT_mesh_gpu_instancing"]["attributes"] = {{"TRANSLATION", 3}};
    EXPECT_TRUE(contains(error(), "too many for a file of its size"));
    extensions = nullptr;
    primitive_of(document_)["attributes"]["POSITION"] = 3;
    EXPECT_TRUE(contains(error(), "too many for a file of its size"));
    primitive_of(document_)["attributes"]["POSITION"] = 0;
    primitive_of(document_)["indices"] = 3;
    document_["accessors"][3]["type"] = "SCALAR";
    EXPECT_TRUE(contains(error(), "too many for a file of its size"));
}

TEST_F(GltfGeometryTest, SparsePositionsReplaceThoseOfTheirList)
{
    const std::size_t places = add_accessor(document_, buffer_, 5121, "SCALAR", 2, std::vector<std::uint8_t>{1, 3});
    const std::size_t values =
        add_accessor(document_, buffer_, 5126, "VEC3", 2, std::vector<float>{7, 0, 0, 0, 8, 0.1f});
    json& positions = document_["accessors"][0];
    const auto view_of = [&](std::size_t accessor) { return document_["accessors"][accessor]["bufferView"]; };
    positions["sparse"] = {{"count", 2},
                           {"indices", {{"bufferView", view_of(places)}, {"componentType", 5121}}},
                           {"values", {{"bufferView", view_of(values)}}}};
    TriangleSoup read = soup();
    EXPECT_EQ(read.vertices[0].position, glm::vec3(0.0f));
    EXPECT_EQ(read.vertices[1].position, glm::vec3(7.0f, 0.0f, 0.0f));
    EXPECT_EQ(read.vertices[2].position, glm::vec3(1.0f, 1.0f, 0.0f));
    EXPECT_EQ(read.vertices[3].position, glm::vec3(0.0f, 8.0f, 0.1f));

    // Without a list of its own, what is not replaced is zero.
    positions.erase("bufferView");
    read = soup();
    EXPECT_EQ(read.vertices[1].position, glm::vec3(7.0f, 0.0f, 0.0f));
    EXPECT_EQ(read.vertices[2].position, glm::vec3(0.0f));
}

TEST_F(GltfGeometryTest, SparseIndicesReplaceThoseOfTheirList)
{
    const std::size_t places = add_accessor(document_, buffer_, 5123, "SCALAR", 3, std::vector<std::uint16_t>{4, 0, 4});
    const std::size_t values = add_accessor(document_, buffer_, 5123, "SCALAR", 3, std::vector<std::uint16_t>{2, 3, 1});
    const auto view_of = [&](std::size_t accessor) { return document_["accessors"][accessor]["bufferView"]; };
    document_["accessors"][2]["sparse"] = {{"count", 3},
                                           {"indices", {{"bufferView", view_of(places)}, {"componentType", 5123}}},
                                           {"values", {{"bufferView", view_of(values)}}}};
    // 0 1 2, 0 2 3 with the first corner replaced by 3 and the fifth by 1, which is given last.
    EXPECT_EQ(soup().triangles, (Buffer<Triangle>{{3, 1, 2}, {0, 1, 3}}));
}

TEST_F(GltfGeometryTest, SparseListsThatMakeNoSenseAreRefused)
{
    json& sparse = document_["accessors"][0]["sparse"];
    const json right = {{"count", 1},
                        {"indices", {{"bufferView", 2}, {"byteOffset", 2}, {"componentType", 5123}}},
                        {"values", {{"bufferView", 1}}}};
    const auto error_with = [&](const char* pointer, const json& value) {
        sparse = right;
        sparse[json::json_pointer(pointer)] = value;
        return error();
    };
    sparse = right;
    EXPECT_EQ(soup().vertices[1].position, glm::vec3(0.0f, 0.0f, 0.1f));
    EXPECT_TRUE(contains(error_with("/count", 4'000'000'000u), "not inside its buffer view"));
    EXPECT_TRUE(contains(error_with("/indices/byteOffset", 12), "not inside its buffer view"));
    EXPECT_TRUE(contains(error_with("/indices/componentType", 5126), "not integers"));
    EXPECT_TRUE(contains(error_with("/values/bufferView", 9), "names buffer view 9"));
    EXPECT_TRUE(contains(error_with("/values", nullptr), "'values' of the sparse accessor 0 are missing"));
    // The second index of the list is 1: beyond a list of one.
    document_["accessors"][0]["count"] = 1;
    sparse = right;
    EXPECT_TRUE(contains(error(), "out of range"));
}

TEST_F(GltfGeometryTest, ListsWithoutABufferViewAreZeros)
{
    document_["accessors"].push_back({{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
    primitive_of(document_)["attributes"]["NORMAL"] = 3;
    EXPECT_FALSE(soup().has_normals) << "normals without length are none";
    primitive_of(document_)["attributes"]["POSITION"] = 3;
    EXPECT_EQ(soup().vertices.at(2).position, glm::vec3(0.0f));
}

}  // namespace
}  // namespace kerf::core::io
