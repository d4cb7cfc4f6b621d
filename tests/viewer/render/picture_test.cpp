#include "viewer/render/picture.h"

#include <gtest/gtest.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <stb_image.h>
#pragma GCC diagnostic pop

#include "common/io/mesh_file.h"

namespace kerf::test {

namespace {

render::Picture some_picture()
{
    render::Picture picture{7, 5, {}};
    for (int i = 0; i < 7 * 5; ++i)
        for (const int value : {3 * i, 255 - i, (i * i) % 256, 255})
            picture.rgba.push_back(static_cast<std::uint8_t>(value));
    return picture;
}

std::filesystem::path empty_folder()
{
    const std::filesystem::path folder =
        std::filesystem::path(::testing::TempDir()) /
        (std::string("kerf_picture_") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

}  // namespace

TEST(Picture, ReadsBackAsItWasWritten)
{
    const std::filesystem::path path = empty_folder() / "picture.png";
    const render::Picture picture = some_picture();
    render::write_png(path, picture);
    int width = 0, height = 0, channels = 0;
    stbi_uc* const pixels = stbi_load(path.c_str(), &width, &height, &channels, 4);
    ASSERT_NE(pixels, nullptr);
    EXPECT_EQ(channels, 3);
    const render::Picture read{width, height, {pixels, pixels + 4 * width * height}};
    stbi_image_free(pixels);
    EXPECT_TRUE(read == picture);
}

TEST(Picture, ThatCannotBeWrittenLeavesNothing)
{
    const std::filesystem::path folder = empty_folder();
    EXPECT_THROW(render::write_png(folder / "nowhere" / "picture.png", some_picture()), io::FileError);
    EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST(Recording, NumbersItsPictures)
{
    const std::filesystem::path folder = empty_folder() / "a" / "b";
    render::Recording recording(folder);
    recording.add(some_picture());
    recording.add(some_picture());
    EXPECT_EQ(recording.size(), 2);
    EXPECT_TRUE(std::filesystem::exists(folder / "frame_00000.png"));
    EXPECT_TRUE(std::filesystem::exists(folder / "frame_00001.png"));
}

}  // namespace kerf::test
