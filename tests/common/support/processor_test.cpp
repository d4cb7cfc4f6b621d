#include "common/support/processor.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>

namespace kerf::core {
namespace {

TEST(Processor, HasNoAvx2AsLongAsATestTakesItAway)
{
    const bool has = has_avx2();
    {
        const WithoutAvx2 outer;
        {
            const WithoutAvx2 inner;
            EXPECT_FALSE(has_avx2());
        }
        EXPECT_FALSE(has_avx2());
    }
    EXPECT_EQ(has_avx2(), has);
}

#if defined(__linux__) && defined(__x86_64__)
TEST(Processor, HasWhatTheSystemSaysOfIt)
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with("flags")) continue;
        std::istringstream words(line);
        bool said = false;
        for (std::string word; words >> word;) said |= word == "avx2";
        EXPECT_EQ(has_avx2(), said);
        return;
    }
    GTEST_SKIP() << "the system does not say";
}
#endif

}  // namespace
}  // namespace kerf::core
