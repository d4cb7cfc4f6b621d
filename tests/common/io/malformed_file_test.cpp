#include <random>
#include <string>
#include <vector>

#include "common/io/glb_sample.h"
#include "common/io/read_formats.h"
#include "common/io/test_files.h"
#include "support/brief.h"

// Bad input never crashes and never hangs: every sample is cut off at each of its bytes, and damaged at random.

namespace kerf::core::io {
namespace {

struct Sample
{
    std::string name;
    std::string bytes;
};

class MalformedFileTest : public MeshFileTest
{
protected:
    std::vector<Sample> samples() const
    {
        const std::string text_head =
            "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty "
            "uchar red\nproperty uchar green\nproperty uchar blue\nelement face 2\nproperty list "
            "uchar int vertex_indices\nend_header\n";
        std::vector<Sample> all{
            {"a.obj",
             "# x\r\nmtllib a.mtl\nv 0 0 0\nv 1 0 0 \\\n\nv 1 1 0 0.5 1 0\nv 0 1 0\nvt 0 1\nvn 0 0 1\nusemtl m\nf "
             "1/1/1 2//1 "
             "3/1 -1\nf 1 2 3\n"},
            {"a.off",
             "STCNOFF\n3 2 0\n0 0 0  0 0 1  255 0 51  0.5 0.25\n1 0 0  0 0 1  0 0 0 0  0 0\n0 1 0  0 0 1  0.5 0.5 "
             "0.5 1  0 1\n3 0 1 2\n3 2 1 0 # end\n"},
            {"a.ply", "ply\nformat ascii 1.0\n" + text_head +
                          "0 0 0 1 2 3\n1 0 0 4 5 6\n1 1 0 7 8 9\n0 1 0 9 9 9\n"
                          "3 0 1 2\n4 0 1 2 3\n"},
            {"a.stl",
             "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
             "endfacet\nendsolid x\n"},
            {"a.glb", glb(sample_document(), sample_buffer())},
            {"a.gltf", ""},
        };
        nlohmann::json document = sample_document();
        document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64(sample_buffer());
        all.back().bytes = document.dump();
        for (const std::string extension : {"obj", "ply", "stl", "glb"}) {
            const std::filesystem::path path = file("written." + extension);
            write_mesh(path, sample_mesh());
            all.push_back({"b." + extension, read_text(path)});
        }
        return all;
    }

    /// The readers themselves: thousands of files would have to be written otherwise.
    static auto reader(const std::string& name)
        -> TriangleSoup (*)(const std::filesystem::path&, std::string_view, ReadingNotes&)
    {
        if (name.ends_with(".obj")) return read_obj;
        if (name.ends_with(".off")) return read_off;
        if (name.ends_with(".ply")) return read_ply;
        if (name.ends_with(".stl")) return read_stl;
        return read_gltf;
    }

    /// A usable mesh, or FileError; anything else leaves the test or the program.
    bool is_read(const std::string& name, const std::string& bytes) const
    {
        try {
            ReadingNotes notes;
            const TriangleSoup soup = reader(name)(file(name), bytes, notes);
            EXPECT_FALSE(soup.triangles.empty());
            for (const Triangle& t : soup.triangles)
                for (const std::uint32_t v : t) EXPECT_LT(v, soup.vertices.size());
            for (const VertexStream& stream : soup.streams)
                EXPECT_EQ(stream.values.size(), stream.width * soup.vertices.size());
            return true;
        } catch (const FileError&) {
            return false;
        }
    }
};

TEST_F(MalformedFileTest, SamplesAreReadWhenNothingIsWrong)
{
    for (const Sample& sample : samples()) EXPECT_TRUE(is_read(sample.name, sample.bytes)) << sample.name;
}

TEST_F(MalformedFileTest, IsReadOrRefusedWhenCutOffAtAnyByte)
{
    for (const Sample& sample : samples()) {
        SCOPED_TRACE(sample.name);
        for (std::size_t size = 0; size < sample.bytes.size(); ++size)
            is_read(sample.name, sample.bytes.substr(0, size));
    }
}

TEST_F(MalformedFileTest, IsRefusedWhenABinaryFileIsCutOffAtAnyByte)
{
    for (const Sample& sample : samples()) {
        if (sample.name[0] != 'b' || sample.name == "b.obj") continue;
        for (std::size_t size = 0; size < sample.bytes.size(); ++size)
            ASSERT_FALSE(is_read(sample.name, sample.bytes.substr(0, size))) << sample.name << " at " << size;
    }
}

TEST_F(MalformedFileTest, IsReadOrRefusedWithBytesChangedAtRandom)
{
    for (const Sample& sample : samples()) {
        constexpr int kTries = test::kBrief ? 1000 : 10000;
        SCOPED_TRACE(sample.name);
        std::mt19937 random(1);
        for (int i = 0; i < kTries; ++i) {
            std::string bytes = sample.bytes;
            for (std::uint32_t k = 0; k < 1 + random() % 4; ++k) {
                const std::size_t at = random() % bytes.size();
                const std::uint32_t what = random() % 4;
                if (what == 0) bytes[at] = static_cast<char>(random());
                if (what == 1) bytes[at] = static_cast<char>('0' + random() % 10);
                if (what == 2) bytes.erase(at, 1 + random() % 8);
                if (what == 3) bytes.insert(at, 1, "-9e. \n/"[random() % 7]);
                if (bytes.empty()) break;
            }
            is_read(sample.name, bytes);
        }
    }
}

TEST_F(MalformedFileTest, IsRefusedWhenThereIsNoUsableFile)
{
    EXPECT_TRUE(contains(error_of(file("none.obj")), "no such file"));
    EXPECT_TRUE(contains(error_of("a.xyz", "1 2 3"), "extension"));
    EXPECT_TRUE(contains(error_of("noextension", "1 2 3"), "extension"));
    for (const char* extension : {"obj", "off", "ply", "stl", "gltf", "glb"}) {
        EXPECT_TRUE(contains(error_of("a." + std::string(extension), ""), "it is empty"));
        error_of("a." + std::string(extension), "\n");
        error_of("a." + std::string(extension), std::string(1000, '\0'));
    }
    std::filesystem::create_directory(file("folder.obj"));
    EXPECT_TRUE(contains(error_of(file("folder.obj")), "not a regular file"));
}

TEST_F(MalformedFileTest, IsRefusedInOneLineWhateverItsName)
{
    const std::filesystem::path path = write("red\x1b[31m\nline.obj", "f 1 2 3\n");
    try {
        read_soup(path);
        FAIL() << "it was read";
    } catch (const FileError& error) {
        const std::string message = error.what();
        EXPECT_TRUE(contains(message, "line.obj: line 1")) << message;
        EXPECT_TRUE(std::none_of(message.begin(), message.end(), [](unsigned char c) { return c < 32 || c == 127; }))
            << message;
    }
}

TEST_F(MalformedFileTest, IsRefusedWhenItMayNotBeRead)
{
    const auto path = write("a.obj", "v 0 0 0\n");
    std::filesystem::permissions(path, std::filesystem::perms::none);
    // Root may read everything, and is nobody here, who may look into the folder.
    std::filesystem::permissions(folder_, std::filesystem::perms(0755));
    constexpr ::uid_t kNobody = 65534;
    const ::uid_t user = ::geteuid();
    if (user == 0) {
        ASSERT_EQ(::seteuid(kNobody), 0);
    }
    const std::string error = error_of(path);
    if (user == 0) {
        ASSERT_EQ(::seteuid(user), 0);
    }
    EXPECT_TRUE(contains(error, "cannot be opened")) << error;
}

}  // namespace
}  // namespace kerf::core::io
