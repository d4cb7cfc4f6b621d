#include "viewer/app/picture_name.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

namespace kerf::test {

TEST(PictureName, IsNeverThatOfAPictureOfAnEarlierSession)
{
    std::string pattern = (std::filesystem::temp_directory_path() / "kerf_names_XXXXXX").string();
    const std::filesystem::path folder = ::mkdtemp(pattern.data());
    EXPECT_EQ(app::new_picture_name(folder), folder / "kerf_000.png");
    for (const char* taken : {"kerf_000.png", "kerf_001.png", "kerf_003.png"}) std::ofstream(folder / taken) << "x";
    EXPECT_EQ(app::new_picture_name(folder), folder / "kerf_002.png");
    std::filesystem::remove_all(folder);
}

}  // namespace kerf::test
