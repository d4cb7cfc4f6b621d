#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "common/io/bytes.h"
#include "common/io/glb_sample.h"
#include "common/io/test_files.h"
#include "support/brief.h"

namespace kerf::core::io {
namespace {

using nlohmann::json;
using GlbTest = MeshFileTest;

TEST_F(GlbTest, ReadsPositionsBitForBitWithoutATransform)
{
    const TriangleSoup soup = soup_of("a.glb", glb(sample_document(), sample_buffer()));
    EXPECT_EQ(soup.triangles, (Buffer<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    ASSERT_EQ(soup.vertices.size(), 4u);
    EXPECT_EQ(soup.vertices[1].position, glm::vec3(0.1f, 0.0f, 0.0f));
    EXPECT_EQ(soup.vertices[1].uv, glm::vec2(0.1f, 1.0f)) << "the origin of uv is the lower left corner";
    EXPECT_FALSE(soup.has_normals);
}

TEST_F(GlbTest, ReadsTheBaseColourAndItsTexture)
{
    const TriangleSoup soup = soup_of("a.glb", glb(sample_document(), sample_buffer()));
    ASSERT_FALSE(soup.triangle_materials.empty());
    const Material& material = soup.materials[soup.triangle_materials[0]];
    EXPECT_EQ(material.name, "peel");
    EXPECT_EQ(material.colour, glm::vec4(1.0f, 0.5f, 0.25f, 1.0f));
    EXPECT_EQ(material.texture, "peel.png");
}

TEST_F(GlbTest, AppliesNodeTransformsAndInstancesMeshes)
{
    json document = sample_document();
    document["scenes"][0]["nodes"] = {0, 2};
    document["nodes"] = {{{"children", {1}}, {"translation", {10, 0, 0}}},
                         {{"mesh", 0}, {"scale", {2, 2, 2}}},
                         {{"mesh", 0}, {"matrix", {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 5, 1}}}};
    const TriangleSoup soup = soup_of("a.glb", glb(document, sample_buffer()));
    ASSERT_EQ(soup.vertices.size(), 8u);
    EXPECT_EQ(soup.vertices[1].position, glm::vec3(10.0 + 2.0 * double(0.1f), 0.0, 0.0));
    EXPECT_EQ(soup.vertices[5].position, glm::vec3(-0.1f, 0.0f, 5.0f));
    EXPECT_EQ(soup.triangles[2], (Triangle{6, 5, 4})) << "a mirrored triangle must turn over";
}

TEST_F(GlbTest, ReadsTextWithBuffersInsideAndBeside)
{
    json document = sample_document();
    document["buffers"][0]["uri"] = "a b.bin";
    write("a b.bin", sample_buffer());
    EXPECT_EQ(soup_of("a.gltf", document.dump()).triangles.size(), 2u);
    std::filesystem::remove(file("a b.bin"));
    EXPECT_TRUE(contains(error_of("a.gltf", document.dump()), "'a b.bin', which is not there"));
}

TEST_F(GlbTest, RefusesWhatItsSizesDoNotAllow)
{
    const auto error_with = [&](const char* pointer, const json& value) {
        json document = sample_document();
        document[json::json_pointer(pointer)] = value;
        return error_of("a.glb", glb(document, sample_buffer()));
    };
    EXPECT_TRUE(contains(error_with("/accessors/0/count", 4000000000u), "not inside its buffer view"));
    EXPECT_TRUE(contains(error_with("/accessors/0/count", -4), "makes sense"));
    EXPECT_TRUE(contains(error_with("/accessors/0/byteOffset", 8), "not inside its buffer view"));
    EXPECT_TRUE(contains(error_with("/accessors/0/componentType", 5130), "no type that glTF knows"));
    EXPECT_TRUE(contains(error_with("/accessors/0/type", "VEC2"), "not three numbers"));
    EXPECT_TRUE(contains(error_with("/meshes/0/primitives/0/indices", 1), "not one number"));
    EXPECT_TRUE(contains(error_with("/bufferViews/0/byteOffset", 60), "not inside its buffer"));
    EXPECT_TRUE(contains(error_with("/buffers/0/byteLength", 96), "truncated"));
    EXPECT_TRUE(
        contains(error_with("/meshes/0/primitives/0/attributes/POSITION", 9), "names accessor 9, but there are only"));
    EXPECT_TRUE(contains(error_with("/meshes/0/primitives/0/mode", 1), "no triangles"));
    EXPECT_TRUE(contains(error_with("/nodes/0/mesh", 1), "node 0 names mesh 1, but there are only 1"));
    EXPECT_TRUE(contains(error_with("/nodes/0/children", json::array({0})), "below themselves"));
    EXPECT_TRUE(contains(error_with("/nodes/0/children", json::array({7})), "names node 7"));
    EXPECT_TRUE(contains(error_with("/nodes/0/translation", json::array({0, 1})), "not 3 numbers"));
    EXPECT_TRUE(contains(error_with("/asset/version", "1.0"), "not version 2"));
}

TEST_F(GlbTest, RefusesIndicesOutOfRangeAndCoordinatesThatAreNotFinite)
{
    std::string buffer = sample_buffer();
    buffer[80] = 4;
    EXPECT_TRUE(contains(error_of("a.glb", glb(sample_document(), buffer)),
                         "corner 0 of mesh 0 names vertex 4, but there are only 4"));
    buffer = sample_buffer();
    buffer.replace(0, 4, "\xFF\xFF\xFF\x7F");
    EXPECT_TRUE(contains(error_of("a.glb", glb(sample_document(), buffer)), "not finite"));
}

TEST_F(GlbTest, ReadsBuffersBelowItsFolderAndNowhereElse)
{
    json document = sample_document();
    std::filesystem::create_directory(file("parts"));
    write("parts/a b.bin", sample_buffer());
    document["buffers"][0]["uri"] = "parts/a%20b.bin";
    EXPECT_EQ(soup_of("a.gltf", document.dump()).triangles.size(), 2u);

    write("a.bin", sample_buffer());
    const std::string absolute = file("a.bin").string();
    for (const std::string& uri :
         {absolute, "file://" + absolute, std::string("../a.bin"), std::string("parts/../a.bin"),
          std::string("parts/%2e%2e/a.bin"), std::string("C:\\a.bin"), std::string("..\\a.bin"), std::string("a%0.bin"),
          std::string("a.bin%00"), std::string("http://example.org/a.bin")}) {
        document["buffers"][0]["uri"] = uri;
        EXPECT_TRUE(contains(error_of("parts/a.gltf", document.dump()), "below it")) << uri;
    }
    document["buffers"][0]["uri"] = "parts";
    EXPECT_TRUE(contains(error_of("a.gltf", document.dump()), "not a regular file"));
}

TEST_F(GlbTest, HoldsABufferOnceHoweverOftenItIsNamed)
{
    json document = sample_document();
    // NOLINTNEXTLINE(bugprone-string-constructor): the buffer is meant to be large
    write("a.bin", sample_buffer() + std::string(10'000'000, '\0'));
    document["buffers"][0]["uri"] = "a.bin";
    // 100 GB if each had bytes of its own.
    for (int i = 0; i < 10'000; ++i) document["buffers"].push_back(document["buffers"][0]);
    EXPECT_EQ(soup_of("a.gltf", document.dump()).triangles.size(), 2u);
}

TEST_F(GlbTest, RefusesBase64WithOtherCharacters)
{
    json document = sample_document();
    document["buffers"][0]["uri"] = "data:;base64," + std::string(100, 'A') + "*" + std::string(100, 'A');
    EXPECT_TRUE(contains(error_of("a.gltf", document.dump()), "digit 100"));
    document["buffers"][0]["uri"] = "data:,AAAA";
    EXPECT_TRUE(contains(error_of("a.gltf", document.dump()), "not base64"));
}

TEST_F(GlbTest, ReadsStripsAndFansAndVerticesWithoutIndices)
{
    json document = sample_document();
    json& primitive = document["meshes"][0]["primitives"][0];
    primitive.erase("indices");
    primitive["mode"] = 5;
    EXPECT_EQ(soup_of("a.glb", glb(document, sample_buffer())).triangles, (Buffer<Triangle>{{0, 1, 2}, {1, 3, 2}}));
    primitive["mode"] = 6;
    EXPECT_EQ(soup_of("a.glb", glb(document, sample_buffer())).triangles, (Buffer<Triangle>{{0, 1, 2}, {0, 2, 3}}));
}

TEST_F(GlbTest, ReadsFractionsAsIntegers)
{
    json document = sample_document();
    document["accessors"].push_back(
        {{"bufferView", 0}, {"componentType", 5121}, {"count", 4}, {"type", "VEC4"}, {"normalized", true}});
    document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"] = 3;
    std::string buffer = sample_buffer();
    buffer.replace(0, 4, std::string("\xFF\x00\x33\x00", 4));
    const TriangleSoup soup = soup_of("a.glb", glb(document, buffer));
    ASSERT_EQ(soup.streams.size(), 1u);
    EXPECT_EQ(soup.streams[0].name, "color");
    EXPECT_EQ(soup.streams[0].values[0], 1.0f);
    EXPECT_EQ(soup.streams[0].values[2], 0.2f);
}

TEST_F(GlbTest, TurnsByQuaternionsInDouble)
{
    json document = sample_document();
    const double half = std::sqrt(0.5);
    document["nodes"][0]["rotation"] = {0.0, 0.0, half, half};  // a quarter turn around z
    document["nodes"][0]["translation"] = {0, 0, 7};
    const TriangleSoup soup = soup_of("a.glb", glb(document, sample_buffer()));
    EXPECT_NEAR(soup.vertices[1].position.x, 0.0f, 1e-8f);
    EXPECT_EQ(soup.vertices[1].position.y, 0.1f);
    EXPECT_EQ(soup.vertices[1].position.z, 7.0f);
}

TEST_F(GlbTest, ReadsTheSceneThatTheFileOpensWith)
{
    json document = sample_document();
    document["nodes"] = {{{"mesh", 0}}, {{"mesh", 0}, {"translation", {5, 0, 0}}}};
    document["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
    document["scene"] = 1;
    EXPECT_EQ(soup_of("a.glb", glb(document, sample_buffer())).vertices[0].position.x, 5.0f);
    document["scene"] = 2;
    EXPECT_TRUE(contains(error_of("a.glb", glb(document, sample_buffer())), "names scene 2, but there are only 2"));
    document.erase("scene");
    document.erase("scenes");
    EXPECT_EQ(soup_of("a.glb", glb(document, sample_buffer())).triangles.size(), 4u) << "all roots";
    document.erase("nodes");
    EXPECT_EQ(soup_of("a.glb", glb(document, sample_buffer())).triangles.size(), 2u) << "each mesh";
}

TEST_F(GlbTest, RefusesDeeplyNestedJson)
{
    // Either is more than a call for each bracket has stack for.
    const std::size_t depth = test::kBrief ? 200'000 : 1'000'000;
    EXPECT_TRUE(contains(error_of("a.gltf", std::string(depth, '[')), "malformed"));
    // Balanced, so that it is parsed to its end.
    EXPECT_TRUE(contains(error_of("a.gltf", std::string(depth, '[') + std::string(depth, ']')), "not an object"));
}

TEST_F(GlbTest, RefusesATreeThatMultipliesItself)
{
    json document = sample_document();
    json& nodes = document["nodes"] = json::array();
    document["scenes"][0]["nodes"] = {0};
    // Two of each, both above both of the next: 2^40 copies.
    for (int i = 0; i < 80; i += 2)
        for (int k = 0; k < 2; ++k) nodes.push_back({{"children", {i + 2, i + 3}}, {"mesh", 0}});
    for (int k = 0; k < 2; ++k) nodes.push_back({{"mesh", 0}});
    EXPECT_TRUE(contains(error_of("a.glb", glb(document, sample_buffer())), "two parents"));
}

TEST_F(GlbTest, ReadsNodesHoweverDeepTheyAreNested)
{
    json document = sample_document();
    json& nodes = document["nodes"] = json::array();
    for (int i = 0; i < 20'000; ++i) nodes.push_back({{"children", {i + 1}}, {"translation", {1, 0, 0}}});
    nodes.push_back({{"mesh", 0}});
    EXPECT_EQ(soup_of("a.glb", glb(document, sample_buffer())).vertices[0].position.x, 20'000.0f);
}

TEST_F(GlbTest, WritesMaterialsNodesAndAttributesThatReadBack)
{
    const IndexedMesh mesh = sample_mesh();
    write_mesh(file("a.glb"), mesh);
    const TriangleSoup soup = read_soup(file("a.glb"));
    ASSERT_EQ(soup.triangles.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t read = soup.triangles[t][k], written = mesh.triangles[t][k];
            EXPECT_EQ(soup.vertices[read].position, mesh.vertices[written].position);
            EXPECT_EQ(soup.vertices[read].normal, mesh.vertices[written].normal);
            EXPECT_NEAR(soup.vertices[read].uv.y, mesh.vertices[written].uv.y, 1e-6);
            for (std::size_t i = 0; i < 3; ++i)
                EXPECT_EQ(soup.streams[0].values[4 * read + i], mesh.streams[0].values[3 * written + i]);
        }
    const auto material = [&](std::size_t t) { return soup.materials[soup.triangle_materials[t]]; };
    EXPECT_EQ(material(0).name, "skin");
    EXPECT_EQ(material(0).texture, "peel.png");
    EXPECT_EQ(material(0).colour, mesh.materials[0].colour);
    EXPECT_EQ(material(3).name, "flesh");
}

TEST_F(GlbTest, WritesAnyNumberOfMaterialsAndGroups)
{
    // If each material looked through all groups, they would take minutes.
    constexpr std::uint32_t kMaterials = 200'000;
    IndexedMesh mesh = sample_mesh();
    mesh.materials.assign(kMaterials, {"m", glm::vec4(0.5f), ""});
    mesh.groups.back().material = kMaterials - 1;
    const auto end = static_cast<std::uint32_t>(mesh.triangles.size());
    for (std::uint32_t material = 0; material < kMaterials; ++material)
        mesh.groups.push_back({end, 0, material, 0, TriangleKind::surface});
    write_mesh(file("a.glb"), mesh);
    const TriangleSoup soup = read_soup(file("a.glb"));
    EXPECT_EQ(soup.materials.size(), kMaterials);
    EXPECT_EQ(soup.triangle_materials, (std::vector<std::uint32_t>{0, 0, 1, kMaterials - 1}));
}

TEST_F(GlbTest, WritesAContainerThatKeepsTheRulesOfTheFormat)
{
    write_mesh(file("a.glb"), sample_mesh());
    const std::string bytes = read_text(file("a.glb"));
    const auto number = [&](std::size_t at) { return load<std::uint32_t>(bytes.data() + at, Endian::little); };
    ASSERT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(number(4), 2u);
    EXPECT_EQ(number(8), bytes.size());
    const std::size_t json_size = number(12), binary_size = number(20 + json_size);
    EXPECT_EQ(json_size % 4, 0u);
    EXPECT_EQ(binary_size % 4, 0u);
    EXPECT_EQ(20 + json_size + 8 + binary_size, bytes.size());

    const json document = json::parse(bytes.substr(20, json_size));
    EXPECT_EQ(document["asset"]["version"], "2.0");
    EXPECT_EQ(document["buffers"][0]["byteLength"], binary_size);
    ASSERT_EQ(document["nodes"].size(), 2u);
    EXPECT_EQ(document["nodes"][0]["name"], "surface");
    EXPECT_EQ(document["nodes"][1]["name"], "cap");
    std::size_t covered = 0;
    for (const json& view : document["bufferViews"]) {
        EXPECT_EQ(view["byteOffset"], covered);
        covered += view["byteLength"].get<std::size_t>();
    }
    EXPECT_EQ(covered, binary_size);
    for (const json& mesh : document["meshes"])
        for (const json& primitive : mesh["primitives"]) {
            const json& position = document["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
            EXPECT_EQ(position["min"].size(), 3u);
            EXPECT_EQ(position["max"].size(), 3u);
            EXPECT_LT(primitive["material"], document["materials"].size());
        }
}

}  // namespace
}  // namespace kerf::core::io
