#include "viewer/render/picture.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdlib>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#include <stb_image.h>
#pragma GCC diagnostic pop

#include "common/files/file_error.h"

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
    std::filesystem::path folder =
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
    const render::Picture read{width, height, {pixels, pixels + std::ptrdiff_t{4} * width * height}};
    stbi_image_free(pixels);
    EXPECT_TRUE(read == picture);
}

TEST(Picture, LosesLittleAsJpeg)
{
    const std::filesystem::path path = empty_folder() / "picture.jpg";
    render::Picture smooth{64, 48, {}};
    for (int y = 0; y < 48; ++y)
        for (int x = 0; x < 64; ++x)
            for (const int value : {3 * x, 4 * y, 128, 255}) smooth.rgba.push_back(static_cast<std::uint8_t>(value));
    render::write_jpeg(path, smooth);
    int width = 0, height = 0, channels = 0;
    stbi_uc* const pixels = stbi_load(path.c_str(), &width, &height, &channels, 4);
    ASSERT_NE(pixels, nullptr);
    const render::Picture read{width, height, {pixels, pixels + std::ptrdiff_t{4} * width * height}};
    stbi_image_free(pixels);
    ASSERT_EQ(read.rgba.size(), smooth.rgba.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < read.rgba.size(); ++i) sum += std::abs(int(read.rgba[i]) - int(smooth.rgba[i]));
    EXPECT_LT(sum / static_cast<double>(read.rgba.size()), 3.0);
}

TEST(Picture, ThatCannotBeWrittenLeavesNothing)
{
    const std::filesystem::path folder = empty_folder();
    EXPECT_THROW(render::write_png(folder / "nowhere" / "picture.png", some_picture()), core::io::FileError);
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
