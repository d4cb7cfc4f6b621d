#include <cstdint>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/io/bytes.h"
#include "common/io/glb_sample.h"
#include "common/io/test_files.h"

// What a glTF file holds besides the surface that its scene shows never refuses it, and neither does what is not quite
// glTF but plain: the surface is the sample's own, and a note counts what was passed over.

namespace kerf::core::io {
namespace {

using nlohmann::json;

/// A file that shows the sample's two triangles.
struct Case
{
    std::string name;
    std::function<void(json&, std::string&)> change;  ///< of the sample's document and buffer
    std::string note;                                 ///< part of the clause; empty: nothing to note
    std::uint64_t count = 1;
};

class GltfLeniencyTest : public MeshFileTest
{
protected:
    /// Positions of all corners, in order.
    static std::vector<glm::vec3> corners(const TriangleSoup& soup)
    {
        std::vector<glm::vec3> positions;
        for (const Triangle& triangle : soup.triangles)
            for (const std::uint32_t v : triangle) positions.push_back(soup.vertices[v].position);
        return positions;
    }

    /// The sample's, written down.
    static std::vector<glm::vec3> sample_corners()
    {
        const glm::vec3 a(0.0f, 0.0f, 0.0f), b(0.1f, 0.0f, 0.0f), c(1.0f, 1.0f, 0.0f), d(0.0f, 1.0f, 0.0f);
        return {a, b, c, a, c, d};
    }

    static std::uint64_t count_of(const ReadingNotes& notes, const std::string& part)
    {
        std::uint64_t count = 0;
        for (const ReadingNote& note : notes.list())
            if (contains(note.what, part)) count += note.count;
        return count;
    }

    void expect_sample(const std::string& file_name, const std::string& bytes, const std::string& note,
                       std::uint64_t count)
    {
        try {
            ReadingNotes notes;
            const TriangleSoup soup = read_soup(write(file_name, bytes), &notes);
            EXPECT_EQ(corners(soup), sample_corners());
            if (note.empty())
                EXPECT_TRUE(notes.none()) << notes.describe();
            else
                EXPECT_EQ(count_of(notes, note), count) << notes.describe();
        } catch (const FileError& error) {
            ADD_FAILURE() << error.what();
        }
    }

    void expect_sample(const std::vector<Case>& cases)
    {
        for (const Case& c : cases) {
            SCOPED_TRACE(c.name);
            json document = sample_document();
            std::string buffer = sample_buffer();
            c.change(document, buffer);
            expect_sample("a.glb", glb(document, buffer), c.note, c.count);
        }
    }

    std::string error_with(const std::function<void(json&, std::string&)>& change)
    {
        json document = sample_document();
        std::string buffer = sample_buffer();
        change(document, buffer);
        return error_of("a.glb", glb(document, buffer));
    }
};

TEST_F(GltfLeniencyTest, NumbersAndReferencesThatArePlainAreTaken)
{
    expect_sample(std::vector<Case>{
        {"the sample", [](json&, std::string&) {}, ""},
        {"0.0 and 4.0",
         [](json& d, std::string&) {
             d["bufferViews"][0]["byteOffset"] = 0.0;
             d["accessors"][0]["count"] = 4.0;
             d["scenes"][0]["nodes"][0] = 0.0;
         },
         "written as decimals", 3},
        {"null",
         [](json& d, std::string&) {
             d["bufferViews"][0]["byteOffset"] = nullptr;
             d["nodes"][0]["matrix"] = nullptr;
             d["nodes"][0]["children"] = nullptr;
             primitive_of(d)["mode"] = nullptr;
             primitive_of(d)["extensions"] = nullptr;
             d["skins"] = nullptr;
         },
         "are null", 4},
        {"-1",
         [](json& d, std::string&) {
             primitive_of(d)["material"] = -1;
             d["scene"] = -1;
             d["nodes"].push_back({{"mesh", -1}});
             d["nodes"][0]["children"] = {-1, 1};
         },
         "of -1", 4},
        {"version 2.0 as a number", [](json& d, std::string&) { d["asset"]["version"] = 2.0; }, ""},
        {"no version", [](json& d, std::string&) { d.erase("asset"); }, "version that is missing"},
    });
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) { d["accessors"][0]["count"] = 3.5; }), "makes sense"));
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) { d["accessors"][0]["count"] = -1; }), "makes sense"));
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) { primitive_of(d)["indices"] = -2; }), "makes sense"));
}

TEST_F(GltfLeniencyTest, TextThatIsNotQuiteJsonIsTaken)
{
    const std::string text = sample_document().dump();
    const auto with = [&](const std::string& old, const std::string& now) {
        std::string changed = text;
        const std::size_t at = changed.find(old);
        EXPECT_NE(at, std::string::npos) << old;
        return glb_of_text(changed.replace(at, old.size(), now), sample_buffer());
    };
    expect_sample("tab.glb", with("peel\"", "pe\tel\n\""), "control characters", 2);
    for (const std::string number : {"NaN", "nan", "-nan(ind)", "Infinity", "-inf", "1.#QNAN", "-1.#IND", "1e400"})
        expect_sample("nan.glb", with("\"min\":[0,", "\"min\":[" + number + ","), "numbers of the JSON", 1);
    expect_sample("small.glb", with("\"min\":[0,", "\"min\":[1e-400,"), "", 0);
    expect_sample("latin.glb", with("peel\"", "K\xF6rper \xC3\xA4\""), "Latin-1", 1);
    EXPECT_EQ(read_soup(file("latin.glb")).materials[0].name, "K\xC3\xB6rper \xC3\xA4");
    expect_sample(
        "mark.gltf",
        [&] {
            json document = sample_document();
            document["buffers"][0]["uri"] = "data:;base64," + base64(sample_buffer());
            return "\xEF\xBB\xBF" + document.dump();
        }(),
        "", 0);
}

TEST_F(GltfLeniencyTest, PlaceOfAFaultInTheJsonIsThatInTheFile)
{
    // The fault is behind letters that had to be changed.
    const std::string text = "{\"a\": \"\xF6\xF6\t\xE4\", \"b\": NaN, ]";
    EXPECT_TRUE(contains(error_of("a.gltf", text), "at byte " + std::to_string(text.size()) + ";"));
}

TEST_F(GltfLeniencyTest, NumbersThatAreNotFiniteAreRefusedWhereTheyMatter)
{
    const std::string text = sample_document().dump();
    const std::string node = "\"nodes\":[{\"mesh\":0}]";
    const std::size_t at = text.find(node);
    ASSERT_NE(at, std::string::npos);
    std::string changed = text;
    changed.replace(at, node.size(), "\"nodes\":[{\"mesh\":0,\"translation\":[0,NaN,0]}]");
    EXPECT_TRUE(contains(error_of("a.glb", glb_of_text(changed, sample_buffer())), "not 3 numbers"));
}

TEST_F(GltfLeniencyTest, Base64MayHaveLineEnds)
{
    json document = sample_document();
    std::string digits = base64(sample_buffer());
    digits.insert(70, "\r\n");
    digits += "\n";
    document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + digits;
    expect_sample("a.gltf", document.dump(), "base64", 2);
}

TEST_F(GltfLeniencyTest, DataMayHaveTheirWordsInEitherCaseAndTheirDigitsEscaped)
{
    // Bytes of no accessor, for digits that are escaped: + and /.
    std::string bytes = sample_buffer();
    while (bytes.size() % 3 != 0) bytes += '\0';
    bytes += "\xFB\xEF\xBE\xFF\xFF\xFFx";
    const std::string plain = base64(bytes);
    std::string escaped;
    for (const char c : plain) escaped += c == '+' ? "%2B" : c == '/' ? "%2f" : c == '=' ? "%3D" : std::string(1, c);
    ASSERT_TRUE(contains(escaped, "%2B") && contains(escaped, "%2f") && escaped.ends_with("%3D"));
    json document = sample_document();
    document["buffers"][0]["byteLength"] = bytes.size();
    for (const std::string& uri : {"DATA:application/octet-stream;BASE64," + plain, "Data:;Base64," + plain,
                                   "data:;base64," + escaped, "DATA:;BASE64," + escaped}) {
        SCOPED_TRACE(uri);
        document["buffers"][0]["uri"] = uri;
        expect_sample("a.gltf", document.dump(), "", 0);
    }
    document["buffers"][0]["uri"] = "data:;base64," + plain.substr(0, 72) + "%0D%0A" + plain.substr(72);
    expect_sample("a.gltf", document.dump(), "base64", 2);
    for (const std::string wrong : {"%", "%2", "%G0", "%2A"}) {
        document["buffers"][0]["uri"] = "data:;base64," + plain.substr(0, 4) + wrong + "A" + plain.substr(4);
        EXPECT_TRUE(contains(error_of("a.gltf", document.dump()), "are not base64: digit 4 is none")) << wrong;
    }
}

TEST_F(GltfLeniencyTest, ImagesInsideTheFileAreNoTexturesWhateverTheCase)
{
    for (const char* uri : {"data:image/png;base64,AAAA", "DATA:image/png;base64,AAAA"}) {
        json document = sample_document();
        document["images"][0]["uri"] = uri;
        write("a.glb", glb(document, sample_buffer()));
        EXPECT_EQ(read_soup(file("a.glb")).materials.at(0).texture, "") << uri;
    }
}

TEST_F(GltfLeniencyTest, NamesOfBuffersMayHaveBackslashes)
{
    json document = sample_document();
    std::filesystem::create_directory(file("sub"));
    write("sub/file.bin", sample_buffer());
    document["buffers"][0]["uri"] = "sub\\file.bin";
    expect_sample("a.gltf", document.dump(), "backslashes", 1);
    write("file.bin", sample_buffer());
    for (const char* uri : {"..\\file.bin", "sub\\..\\file.bin", "\\\\host\\file.bin", "C:\\file.bin", "\\file.bin"}) {
        document["buffers"][0]["uri"] = uri;
        EXPECT_TRUE(contains(error_of("sub/a.gltf", document.dump()), "below it")) << uri;
    }
}

TEST_F(GltfLeniencyTest, PartsThatTheSceneDoesNotUseAreNotChecked)
{
    const auto add = [](const char* list, const json& object) {
        return [list, object](json& d, std::string&) { d[list].push_back(object); };
    };
    const json gone = {{"buffer", 0}, {"byteOffset", 4000}, {"byteLength", 100}};
    expect_sample(std::vector<Case>{
        {"an empty accessor",
         add("accessors", {{"bufferView", 0}, {"componentType", 5126}, {"count", 0}, {"type", "VEC3"}}), ""},
        {"an accessor of doubles",
         add("accessors", {{"bufferView", 0}, {"componentType", 5130}, {"count", 1}, {"type", "VEC3"}}), ""},
        {"an accessor of nothing", add("accessors", nullptr), ""},
        {"a buffer without data", add("buffers", {{"byteLength", 100}}), ""},
        {"a buffer that is not there", add("buffers", {{"byteLength", 100}, {"uri", "motion.bin"}}), ""},
        {"a buffer elsewhere", add("buffers", {{"byteLength", 100}, {"uri", "https://example.org/a.bin"}}), ""},
        {"an image's view",
         [&](json& d, std::string&) {
             d["bufferViews"].push_back(gone);
             d["images"].push_back({{"bufferView", 3}, {"mimeType", "image/png"}});
         },
         ""},
        {"a mesh without primitives", add("meshes", json::object()), ""},
        {"a node with a bad mesh", add("nodes", {{"mesh", 7}, {"matrix", "none"}}), ""},
        {"a node below itself", add("nodes", {{"mesh", 0}, {"children", {1}}}), ""},
        {"a transform of a node without meshes",
         [](json& d, std::string&) {
             d["nodes"].push_back({{"translation", {0, 0}}, {"camera", 0}});
             d["nodes"][0]["children"] = {1};
         },
         ""},
        {"a sparse morph target",
         [](json& d, std::string&) {
             d["accessors"].push_back({{"componentType", 5126},
                                       {"count", 4},
                                       {"type", "VEC3"},
                                       {"sparse",
                                        {{"count", 1},
                                         {"indices", {{"bufferView", 2}, {"componentType", 5123}}},
                                         {"values", {{"bufferView", 1}}}}}});
             d["accessors"].push_back({{"componentType", 5126}, {"count", 4}, {"type", "VEC3"}});
             primitive_of(d)["targets"] = {{{"POSITION", 3}}, {{"POSITION", 4}}};
         },
         ""},
        {"animations of no sense", [](json& d, std::string&) { d["animations"] = "none"; }, ""},
        {"materials of no sense",
         [](json& d, std::string&) {
             d["textures"] = 5;
             d["images"] = {1, 2};
         },
         ""},
        {"a mesh of the scene without primitives",
         [](json& d, std::string&) {
             d["meshes"].push_back(json::object());
             d["nodes"].push_back({{"mesh", 1}});
             d["scenes"][0]["nodes"] = {0, 1};
         },
         "without primitives"},
        {"a primitive without positions",
         [](json& d, std::string&) {
             d["meshes"][0]["primitives"].push_back({{"attributes", {{"NORMAL", 0}}}});
             d["meshes"][0]["primitives"].push_back(json::object());
         },
         "without positions", 2},
        {"lines",
         [](json& d, std::string&) {
             d["meshes"][0]["primitives"].push_back({{"attributes", {{"POSITION", 9}}}, {"mode", 1}});
         },
         "points or lines"},
    });
}

TEST_F(GltfLeniencyTest, DecorationThatCannotBeUsedIsLeftOut)
{
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    const auto add = [](const char* name, int component, const char* type, std::size_t count, auto values) {
        return [=](json& d, std::string& b) {
            const std::size_t index = add_accessor(d, b, component, type, count, values);
            primitive_of(d)["attributes"][name] = index;
        };
    };
    expect_sample(std::vector<Case>{
        {"NaN in uv", add("TEXCOORD_0", 5126, "VEC2", 4, std::vector<float>{nan, 0, 0, inf, 1, 1, 0, 1}),
         "texture coordinates that are not finite", 2},
        {"NaN in a normal", add("NORMAL", 5126, "VEC3", 4, std::vector<float>{nan, 0, 0, 0, 0, 1, 0, 0, 1, 0, inf, 1}),
         "normals that are not finite", 2},
        {"NaN in a colour", add("COLOR_0", 5126, "VEC3", 4, std::vector<float>(12, nan)),
         "further attributes that are not finite", 12},
        {"one normal too few", add("NORMAL", 5126, "VEC3", 3, std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}),
         "'NORMAL' that are missing"},
        {"two uv too many", add("TEXCOORD_0", 5126, "VEC2", 6, std::vector<float>(12)), "'TEXCOORD_0' of no vertex", 2},
        {"uv of three numbers", add("TEXCOORD_0", 5126, "VEC3", 4, std::vector<float>(12)), ""},
        {"uv of one number", add("TEXCOORD_0", 5126, "SCALAR", 4, std::vector<float>(4)), "another shape"},
        {"normals of two numbers", add("NORMAL", 5126, "VEC2", 4, std::vector<float>(8)), "another shape"},
        {"colours of nine numbers", add("COLOR_0", 5126, "MAT3", 4, std::vector<float>(36)), "another shape"},
        {"normals beyond the end", add("NORMAL", 5126, "VEC3", 5000, std::vector<float>(12)),
         "'NORMAL' that cannot be read"},
        {"uv of an unknown type", add("TEXCOORD_0", 5130, "VEC2", 4, std::vector<double>(8)),
         "'TEXCOORD_0' that cannot be read"},
        {"uv that are not there", [](json& d, std::string&) { primitive_of(d)["attributes"]["TEXCOORD_0"] = 77; },
         "'TEXCOORD_0' that cannot be read"},
        {"a material that is not there", [](json& d, std::string&) { primitive_of(d)["material"] = 5; },
         "taken as none"},
        {"a material that is a name", [](json& d, std::string&) { primitive_of(d)["material"] = "peel"; },
         "taken as none"},
        {"another attribute", [](json& d, std::string&) { primitive_of(d)["attributes"]["_BATCHID"] = "x"; }, ""},
    });
}

TEST_F(GltfLeniencyTest, MissingNormalsAreMadeAnewAndTheOthersKept)
{
    json document = sample_document();
    std::string buffer = sample_buffer();
    const std::vector<float> slanted{0.6f, 0.0f, 0.8f, 0.6f, 0.0f, 0.8f, 0.6f, 0.0f, 0.8f};
    const std::size_t index = add_accessor(document, buffer, 5126, "VEC3", 3, slanted);
    primitive_of(document)["attributes"]["NORMAL"] = index;
    const TriangleSoup soup = soup_of("a.glb", glb(document, buffer));
    EXPECT_EQ(soup.vertices[2].normal, glm::vec3(0.6f, 0.0f, 0.8f));
    EXPECT_EQ(soup.vertices[3].normal, glm::vec3(0.0f, 0.0f, 1.0f));
}

TEST_F(GltfLeniencyTest, ColoursMayHaveAnyType)
{
    const auto colour_of = [&](int component, const char* type, std::size_t width, auto values) {
        json document = sample_document();
        std::string buffer = sample_buffer();
        values.resize(4 * width);
        const std::size_t index = add_accessor(document, buffer, component, type, 4, values);
        primitive_of(document)["attributes"]["COLOR_0"] = index;
        const TriangleSoup soup = soup_of("a.glb", glb(document, buffer));
        EXPECT_EQ(corners(soup), sample_corners());
        const auto& all = soup.streams.at(0).values;
        return glm::vec4(all[0], all[1], all[2], all[3]);
    };
    EXPECT_EQ(colour_of(5126, "VEC3", 3, std::vector<float>{0.25f, 0.5f, 1.0f}), glm::vec4(0.25f, 0.5f, 1.0f, 1.0f));
    EXPECT_EQ(colour_of(5121, "VEC3", 3, std::vector<std::uint8_t>{255, 51, 0}), glm::vec4(1.0f, 0.2f, 0.0f, 1.0f));
    EXPECT_EQ(colour_of(5120, "VEC3", 3, std::vector<std::int8_t>{127, 0, -127}), glm::vec4(1.0f, 0.0f, -1.0f, 1.0f));
    EXPECT_EQ(colour_of(5122, "VEC4", 4, std::vector<std::int16_t>{32767, 0, 0, 32767}),
              glm::vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(colour_of(5125, "VEC3", 3, std::vector<std::uint32_t>{0xFFFFFFFFu, 0, 0x33333333u}),
              glm::vec4(1.0f, 0.0f, 0.2f, 1.0f));
    EXPECT_EQ(colour_of(5121, "SCALAR", 1, std::vector<std::uint8_t>{51}), glm::vec4(0.2f, 0.2f, 0.2f, 1.0f));
    EXPECT_EQ(colour_of(5126, "VEC2", 2, std::vector<float>{0.5f, 0.25f}), glm::vec4(0.5f, 0.5f, 0.5f, 0.25f));
}

TEST_F(GltfLeniencyTest, ANodeStandsInOnePlaceHoweverOftenItIsNamed)
{
    const auto two_nodes = [](json& d) { d["nodes"] = {{{"children", {1}}, {"name", "root"}}, {{"mesh", 0}}}; };
    expect_sample(std::vector<Case>{
        {"a root twice",
         [](json& d, std::string&) {
             d["scenes"][0]["nodes"] = {0, 0};
         },
         "named again"},
        {"a child twice",
         [&](json& d, std::string&) {
             two_nodes(d);
             d["nodes"][0]["children"] = {1, 1};
         },
         "named again"},
        {"a child and its parent",
         [&](json& d, std::string&) {
             two_nodes(d);
             d["scenes"][0]["nodes"] = {1, 0};
         },
         "below others"},
        {"a child alone",
         [&](json& d, std::string&) {
             two_nodes(d);
             d["nodes"][0]["translation"] = {5, 0, 0};  // of a node that the scene does not show
             d["scenes"][0]["nodes"] = {1};
         },
         "below others"},
    });
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) {
                             d["nodes"] = {{{"children", {2}}}, {{"children", {2}}}, {{"mesh", 0}}};
                             d["scenes"][0]["nodes"] = {0, 1};
                         }),
                         "node 2 has two parents"));
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) {
                             d["nodes"] = {{{"children", {1}}, {"mesh", 0}}, {{"children", {0}}}};
                         }),
                         "below themselves"));
}

TEST_F(GltfLeniencyTest, AChildThatTheSceneNamesTooStandsBelowItsParent)
{
    json document = sample_document();
    document["nodes"] = {{{"children", {1}}, {"translation", {5, 0, 0}}}, {{"mesh", 0}}};
    document["scenes"][0]["nodes"] = {1, 0};
    const TriangleSoup soup = soup_of("a.glb", glb(document, sample_buffer()));
    ASSERT_EQ(soup.triangles.size(), 2u);
    EXPECT_EQ(soup.vertices[0].position, glm::vec3(5.0f, 0.0f, 0.0f));
}

TEST_F(GltfLeniencyTest, ASceneThatShowsNoMeshGivesWayToAllNodesAndMeshes)
{
    expect_sample(std::vector<Case>{
        {"no nodes in the scene", [](json& d, std::string&) { d["scenes"][0].erase("nodes"); }, "show no mesh"},
        {"a camera in the scene",
         [](json& d, std::string&) {
             d["nodes"].push_back({{"camera", 0}});
             d["scenes"][0]["nodes"] = {1};
         },
         "show no mesh"},
        {"no node with a mesh", [](json& d, std::string&) { d["nodes"][0].erase("mesh"); }, "show no mesh"},
        {"no scene", [](json& d, std::string&) { d.erase("scenes"); }, ""},
        {"neither scene nor nodes",
         [](json& d, std::string&) {
             d.erase("scenes");
             d.erase("nodes");
         },
         ""},
    });
}

TEST_F(GltfLeniencyTest, CornersBehindTheLastWholeTriangleAreLeftOut)
{
    expect_sample(std::vector<Case>{{"8 indices",
                                     [](json& d, std::string& b) {
                                         for (const int i : {1, 2}) store_little(b, static_cast<std::uint16_t>(i));
                                         d["accessors"][2]["count"] = 8;
                                         d["bufferViews"][2]["byteLength"] = 16;
                                         d["buffers"][0]["byteLength"] = b.size();
                                     },
                                     "last whole triangle", 2}});
    json document = sample_document();
    document["accessors"][2]["count"] = 5;
    EXPECT_EQ(soup_of("a.glb", glb(document, sample_buffer())).triangles, (Buffer<Triangle>{{0, 1, 2}}));
    document["accessors"][2]["count"] = 2;
    EXPECT_TRUE(contains(error_of("a.glb", glb(document, sample_buffer())), "no triangles"));
}

TEST_F(GltfLeniencyTest, IndicesMayBeNumbersOfAnyTypeIfTheyAreWhole)
{
    json document = sample_document();
    std::string buffer = sample_buffer();
    const std::size_t index = add_accessor(document, buffer, 5126, "SCALAR", 6, std::vector<float>{0, 1, 2, 0, 2, 3});
    primitive_of(document)["indices"] = index;
    expect_sample("a.glb", glb(document, buffer), "no unsigned integers", 1);
    const std::size_t wrong = add_accessor(document, buffer, 5126, "SCALAR", 3, std::vector<float>{0, 1, 1.5f});
    primitive_of(document)["indices"] = wrong;
    EXPECT_TRUE(contains(error_of("a.glb", glb(document, buffer)), "names vertex 1.5"));
    const std::size_t negative = add_accessor(document, buffer, 5122, "SCALAR", 3, std::vector<std::int16_t>{0, 1, -1});
    primitive_of(document)["indices"] = negative;
    EXPECT_TRUE(contains(error_of("a.glb", glb(document, buffer)), "names vertex -1"));
}

TEST_F(GltfLeniencyTest, VerticesOfNoFaceMayBeNoNumbers)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    json document = sample_document();
    std::string buffer = sample_buffer();
    primitive_of(document)["attributes"]["POSITION"] =
        add_accessor(document, buffer, 5126, "VEC3", 6,
                     std::vector<float>{0, 0, 0, 0.1f, 0, 0, 1, 1, 0, 0, 1, 0, nan, 0, 0, 0, nan, nan});
    for (int copies = 0; copies < 2; ++copies) document["meshes"][0]["primitives"].push_back(primitive_of(document));
    write("a.glb", glb(document, buffer));
    ReadingNotes notes;
    EXPECT_EQ(read_soup(file("a.glb"), &notes).triangles.size(), 6u);
    EXPECT_EQ(count_of(notes, "vertices of no face that are not finite numbers"), 2u) << notes.describe();
}

TEST_F(GltfLeniencyTest, LengthsMayPassTheEndByPadding)
{
    expect_sample(std::vector<Case>{
        {"a buffer", [](json& d, std::string&) { d["buffers"][0]["byteLength"] = 94; }, "by padding"},
        {"a buffer view", [](json& d, std::string&) { d["bufferViews"][2]["byteLength"] = 14; }, "by padding"},
        {"no length", [](json& d, std::string&) { d["buffers"][0].erase("byteLength"); }, ""},
        {"no name", [](json& d, std::string&) { d["buffers"][0]["uri"] = ""; }, ""},
        {"length 0", [](json& d, std::string&) { d["buffers"][0]["byteLength"] = 0; }, "said to have no bytes"},
        {"a long stride",
         [](json& d, std::string& b) {
             std::string wide;
             for (std::size_t i = 0; i < 4; ++i) wide += b.substr(12 * i, 12) + std::string(300, '\x7F');
             d["bufferViews"][0] = {
                 {"buffer", 0}, {"byteOffset", 92}, {"byteLength", wide.size()}, {"byteStride", 312}};
             b += wide;
             d["buffers"][0]["byteLength"] = b.size();
         },
         ""},
    });
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) { d["buffers"][0]["byteLength"] = 96; }), "truncated"));
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) { d["bufferViews"][2]["byteLength"] = 16; }),
                         "not inside its buffer"));
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) {
                             d["accessors"][2]["count"] = 7;
                             d["bufferViews"][2]["byteLength"] = 14;
                         }),
                         "not inside its buffer view"));
}

TEST_F(GltfLeniencyTest, ChunksNeedNoLengthThatIsAMultipleOfFour)
{
    std::string text = sample_document().dump();
    while (text.size() % 4 != 1) text += ' ';
    const std::string buffer = sample_buffer();
    for (const std::size_t padding : {std::size_t{0}, std::size_t{3}}) {
        SCOPED_TRACE(padding);
        std::string bytes = "glTF";
        for (const std::size_t n : {std::size_t{2}, 28 + text.size() + padding + buffer.size(), text.size()})
            store_little(bytes, static_cast<std::uint32_t>(n));
        bytes += "JSON" + text + std::string(padding, ' ');
        store_little(bytes, static_cast<std::uint32_t>(buffer.size()));
        expect_sample("a.glb", bytes + std::string("BIN\0", 4) + buffer, "multiple of four", 1);
    }
    // Whatever stands behind the end.
    expect_sample("b.glb", glb(sample_document(), sample_buffer()) + "and more than that", "bytes behind", 18);
}

TEST_F(GltfLeniencyTest, RequiredExtensionsThatLeaveTheSurfaceAloneAreNoted)
{
    for (const std::string name :
         {"KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif", "MSFT_texture_dds", "KHR_animation_pointer",
          "KHR_node_visibility", "KHR_xmp_json_ld", "VRM", "VRMC_vrm", "KHR_audio_emitter", "EXT_mesh_features",
          "EXT_structural_metadata", "EXT_lights_image_based", "FB_ngon_encoding", "KHR_materials_unlit",
          "ANOTHER_that_nobody_knows"})
        expect_sample(std::vector<Case>{{name,
                                         [&](json& d, std::string&) {
                                             d["extensionsRequired"] = {name};
                                             d["nodes"][0]["extensions"][name] = {{"a", 1}};
                                             d["materials"][0]["extensions"][name] = {{"a", 1}};
                                             d["extensions"][name] = {{"a", 1}};
                                         },
                                         "extension '" + name + "' passed over"}});
    for (const std::string name : {"EXT_mesh_features", "KHR_materials_variants", "FB_ngon_encoding"})
        expect_sample(std::vector<Case>{{name,
                                         [&](json& d, std::string&) {
                                             d["extensionsRequired"] = {name};
                                             primitive_of(d)["extensions"][name] = {{"a", 1}};
                                         },
                                         "extension '" + name + "' passed over"}});
    expect_sample(std::vector<Case>{
        {"read",
         [](json& d, std::string&) {
             d["extensionsRequired"] = {"KHR_mesh_quantization", "KHR_texture_transform"};
         },
         ""},
        {"no text", [](json& d, std::string&) { d["extensionsRequired"] = {5}; }, "extension '?'"},
    });
}

TEST_F(GltfLeniencyTest, RequiredExtensionsThatMayChangeTheSurfaceAreRefused)
{
    const std::string name = "ANOTHER_compression";
    for (const char* place :
         {"/meshes/0", "/meshes/0/primitives/0", "/accessors/0", "/bufferViews/0", "/buffers/0", "/accessors/2"}) {
        const std::string error = error_with([&](json& d, std::string&) {
            d["extensionsRequired"] = {name};
            d[json::json_pointer(place)]["extensions"][name] = {{"a", 1}};
        });
        EXPECT_TRUE(contains(error, "'ANOTHER_compression', which may change its triangles")) << error;
    }
    // One that is null is not there.
    expect_sample(std::vector<Case>{{"null",
                                     [&](json& d, std::string&) {
                                         d["extensionsRequired"] = {name};
                                         for (const char* place : {"/meshes/0", "/meshes/0/primitives/0", "/buffers/0"})
                                             d[json::json_pointer(place)]["extensions"][name] = nullptr;
                                     },
                                     "are null", 3}});
    // Where it is not required, what the file holds besides it is the surface as well.
    expect_sample(std::vector<Case>{{"not required",
                                     [&](json& d, std::string&) {
                                         primitive_of(d)["extensions"][name] = {{"a", 1}};
                                     },
                                     ""}});
}

TEST_F(GltfLeniencyTest, DracoRefusesOnlyWhereTheSceneHasNothingElse)
{
    const std::string draco = "KHR_draco_mesh_compression";
    const auto compress = [&](json& primitive) { primitive["extensions"][draco] = {{"bufferView", 1}}; };
    for (const bool is_required : {false, true}) {
        const auto require = [&](json& d) {
            if (is_required) d["extensionsRequired"] = {draco};
        };
        expect_sample(std::vector<Case>{{"with a copy",
                                         [&](json& d, std::string&) {
                                             require(d);
                                             compress(primitive_of(d));
                                         },
                                         "uncompressed copies"},
                                        {"on a mesh that no node shows",
                                         [&](json& d, std::string&) {
                                             require(d);
                                             d["meshes"].push_back(d["meshes"][0]);
                                             json& primitive = d["meshes"][1]["primitives"][0];
                                             compress(primitive);
                                             primitive["attributes"].erase("POSITION");
                                         },
                                         is_required ? "extension '" + draco + "' passed over" : ""}});
        for (const char* accessor : {"/accessors/0", "/accessors/2"})
            EXPECT_TRUE(contains(error_with([&](json& d, std::string&) {
                                     require(d);
                                     compress(primitive_of(d));
                                     d[json::json_pointer(accessor)].erase("bufferView");
                                 }),
                                 "compressed by KHR_draco_mesh_compression"))
                << accessor;
        EXPECT_TRUE(contains(error_with([&](json& d, std::string&) {
                                 require(d);
                                 compress(primitive_of(d));
                                 primitive_of(d)["attributes"].erase("POSITION");
                             }),
                             "compressed by KHR_draco_mesh_compression"));
    }
}

TEST_F(GltfLeniencyTest, AListLongerThanTheFileAllowsIsNotCalledCopies)
{
    const std::string error = error_with([](json& d, std::string&) {
        d["accessors"][0].erase("bufferView");
        d["accessors"][0]["count"] = std::uint64_t{1} << 40;
    });
    EXPECT_TRUE(contains(error,
                         "mesh 0 asks for more than 1048576 vertices and corners, too many for a file of its size; "
                         "export it again"))
        << error;
    // Sums of them must not begin at 0 again.
    EXPECT_TRUE(contains(error_with([](json& d, std::string&) {
                             d["accessors"][0].erase("bufferView");
                             d["accessors"][0]["count"] = std::uint64_t{1} << 47;
                             const json primitive = {{"attributes", {{"POSITION", 0}}}, {"mode", 5}};
                             json& primitives = d["meshes"][0]["primitives"] = json::array();
                             for (int i = 0; i < 1 << 16; ++i) primitives.push_back(primitive);
                         }),
                         "mesh 0 asks for more than"));
}

TEST_F(GltfLeniencyTest, WhatStandsBehindTheEndIsCounted)
{
    const std::string good = glb(sample_document(), sample_buffer());
    const std::string behind = "bytes behind the end passed over";
    expect_sample("a.glb", good, "", 0);
    expect_sample("a.glb", good + "and more than that", behind, 18);
    std::string chunk;
    store_little(chunk, std::uint32_t{4});
    expect_sample("a.glb", good + chunk + "MORE" + "1234", behind, 12);
    std::string shorter = good;
    shorter[8] = 50;
    shorter[9] = 0;
    expect_sample("a.glb", shorter, "chunks that pass the end that the header gives read", 2);
    std::string longer = good;
    longer.replace(8, 4, "\xFF\xFF\xFF\xFF");
    expect_sample("a.glb", longer, "larger than the file, whose chunks are whole", 1);
    json document = sample_document();
    document["buffers"][0]["uri"] = "data:;base64," + base64(sample_buffer());
    expect_sample("a.gltf", document.dump() + std::string("\0x", 2), behind, 2);
}

TEST_F(GltfLeniencyTest, FilesThatWereCutOffAreTruncatedWhereverThatWas)
{
    const std::string good = glb(sample_document(), sample_buffer());
    for (std::size_t size = 12; size < good.size(); ++size)
        EXPECT_TRUE(contains(error_of("a.glb", good.substr(0, size)), "truncated")) << size;
}

TEST_F(GltfLeniencyTest, CompressedViewsAreReadFromTheirUncompressedCopies)
{
    const auto compress = [](json& d) {
        d["extensionsRequired"] = {"EXT_meshopt_compression"};
        d["buffers"].push_back(
            {{"byteLength", 92}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
        for (json& view : d["bufferViews"]) {
            view["buffer"] = 1;
            view["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0}, {"byteLength", 10}, {"count", 4}};
        }
    };
    expect_sample(std::vector<Case>{{"with a copy",
                                     [&](json& d, std::string& b) {
                                         compress(d);
                                         d["buffers"][1]["uri"] = "data:;base64," + base64(b);
                                     },
                                     "uncompressed copies", 3}});
    EXPECT_TRUE(
        contains(error_with([&](json& d, std::string&) { compress(d); }), "compressed by EXT_meshopt_compression"));
    EXPECT_TRUE(contains(error_with([&](json& d, std::string&) {
                             compress(d);
                             std::swap(d["buffers"][0], d["buffers"][1]);
                             for (json& view : d["bufferViews"]) view["buffer"] = 0;
                         }),
                         "compressed by EXT_meshopt_compression"));
}

}  // namespace
}  // namespace kerf::core::io
