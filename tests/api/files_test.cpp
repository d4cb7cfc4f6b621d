#include <gtest/gtest.h>
#include <kerf/io.h>
#include <kerf/mesh.h>

#include <filesystem>
#include <string>

#include "api/objects.h"
#include "support/temporary_folder.h"

namespace kerf {
namespace {

TEST(Files, AreReadAgainByTheNameInTheReport)
{
    const test::TemporaryFolder folder;
    const std::string path = folder.file("a name that is too long to be kept inside a string.obj").string();
    ASSERT_TRUE(write_mesh(test::mesh_of(test::cube_arrays()), path.c_str()));
    FileReport report;
    ASSERT_TRUE(read_mesh(path.c_str(), &report));
    for (int i = 0; i < 2; ++i) {
        const Result<Mesh> again = read_mesh(report.file(0), &report);
        ASSERT_TRUE(again) << again.reason();
        EXPECT_EQ(report.file(0), path);
    }
    std::filesystem::remove(path);
    EXPECT_EQ(read_mesh(report.file(0), &report).status(), Status::unusable_file);
    EXPECT_EQ(report.file_count(), 0u) << "there is no mesh";
}

TEST(Files, KeepTheNamesOfImages)
{
    const test::TemporaryFolder folder;
    for (const char* image : {"peel.png", "a picture.png", "gr\u00fcn.png", "red#1.png", "100%.png", "%20.png"}) {
        Material material;
        material.base_colour_image = image;
        const test::Arrays cube = test::cube_arrays();
        MeshInput input = cube.input();
        input.materials = {&material, 1};
        const Mesh mesh = *Mesh::make(input);
        for (const char* format : {"glb", "obj"}) {
            const std::string path = folder.file("cube.").string() + format;
            for (int trip = 0; trip < 2; ++trip) {
                ASSERT_TRUE(write_mesh(trip == 0 ? mesh : *read_mesh(path.c_str()), path.c_str()));
                const Result<Mesh> read = read_mesh(path.c_str());
                ASSERT_TRUE(read) << read.reason();
                EXPECT_STREQ(read->material(0).base_colour_image, image) << format;
            }
        }
    }
}

}  // namespace
}  // namespace kerf
