#include <kerf/version.h>

#include <gtest/gtest.h>

#include <string>

namespace kerf {
namespace {

TEST(Version, OfHeadersAndLibraryIsOne)
{
    EXPECT_STREQ(version(), KERF_VERSION);
    EXPECT_EQ(std::string(KERF_VERSION), std::to_string(KERF_VERSION_MAJOR) + "." + std::to_string(KERF_VERSION_MINOR) +
                                             "." + std::to_string(KERF_VERSION_PATCH));
    EXPECT_STREQ(KERF_VERSION, KERF_PROJECT_VERSION) << "as CMakeLists.txt reads it";
}

TEST(Version, OfTheBitsCountsUpFromOne)
{
    EXPECT_GE(bits_version(), 1u);
}

}  // namespace
}  // namespace kerf
