#include "viewer/app/picture_name.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace kerf::test {

TEST(PictureName, IsNeverThatOfAPictureOfAnEarlierSession)
{
    const TemporaryFolder folder;
    EXPECT_EQ(app::new_picture_name(folder.path()), folder.file("kerf_000.png"));
    for (const char* taken : {"kerf_000.png", "kerf_001.png", "kerf_003.png"}) folder.write(taken, "x");
    EXPECT_EQ(app::new_picture_name(folder.path()), folder.file("kerf_002.png"));
}

}  // namespace kerf::test
