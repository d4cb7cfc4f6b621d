#include <gtest/gtest.h>
#include <kerf/io.h>
#include <kerf/mesh.h>
#include <kerf/shapes.h>

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

TEST(Files, WithoutANameAreRefused)
{
    const Mesh mesh = *make_shape("box", 12);
    MeshFileSet set;
    for (const char* name : {static_cast<const char*>(nullptr), ""}) {
        EXPECT_EQ(read_mesh(name).status(), Status::invalid_argument);
        EXPECT_STREQ(read_mesh(name).reason(), "there is no name of a file");
        EXPECT_EQ(write_mesh(mesh, name).status(), Status::invalid_argument);
        EXPECT_EQ(set.add(name, mesh).status(), Status::invalid_argument);
    }
}

TEST(Files, OfASetAreProtectedWheneverTheyAreNamed)
{
    const test::TemporaryFolder folder;
    const std::string first = folder.file("first.ply").string(), second = folder.file("second.ply").string();
    ASSERT_TRUE(write_mesh(*make_shape("box", 12), first.c_str()));
    ASSERT_TRUE(write_mesh(*make_shape("cone", 100), second.c_str()));
    FileReport first_read, second_read;
    const Mesh mesh = *read_mesh(first.c_str(), &first_read);
    ASSERT_TRUE(read_mesh(second.c_str(), &second_read));
    {
        MeshFileSet set(first_read);
        ASSERT_TRUE(set.protect(second_read));
        EXPECT_EQ(set.add(first.c_str(), mesh).status(), Status::unusable_file);
        EXPECT_EQ(set.add(second.c_str(), mesh).status(), Status::unusable_file);
    }
    // What was added before it is known to be read is refused then, and stays as it was.
    MeshFileSet set(first_read);
    ASSERT_TRUE(set.add(second.c_str(), mesh));
    EXPECT_EQ(set.protect(second_read).status(), Status::unusable_file);
    ASSERT_TRUE(set.commit());
    EXPECT_EQ(read_mesh(second.c_str())->triangle_count(), 12u);
}

}  // namespace
}  // namespace kerf
