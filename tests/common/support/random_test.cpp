#include "common/support/random.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kerf::core {
namespace {

// The numbers of the authors' program (splitmix64.c) for the seed 1234567.
TEST(SplitMix, GivesTheSameNumbersAsItsAuthorsProgram)
{
    Random random(1234567);
    for (const std::uint64_t expected : {6457827717110365317u, 3203168211198807973u, 9817491932198370423u,
                                         4593380528125082431u, 16408922859458223821u})
        EXPECT_EQ(random.next(), expected);
}

TEST(SplitMix, KeepsToItsRanges)
{
    Random random(1);
    double least = 1.0, most = 0.0;
    for (int i = 0; i < 10'000; ++i) {
        const double unit = random.unit();
        EXPECT_GE(unit, 0.0);
        EXPECT_LT(unit, 1.0);
        least = std::min(least, unit);
        most = std::max(most, unit);
        EXPECT_LT(random.below(7), 7u);
        EXPECT_EQ(random.below(1), 0u);
    }
    EXPECT_LT(least, 0.01);
    EXPECT_GT(most, 0.99);
}

}  // namespace
}  // namespace kerf::core
