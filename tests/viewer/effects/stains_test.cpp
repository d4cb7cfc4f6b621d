#include "viewer/effects/stains.h"

#include <gtest/gtest.h>

namespace kerf::test {

using effects::Stain;
using effects::Stains;

TEST(Stain, AppearsRunsDownAndDriesAway)
{
    Stain stain;
    EXPECT_EQ(stain.spread(), 0.0f);
    EXPECT_EQ(stain.run(), 0.0f);
    EXPECT_EQ(stain.opacity(), 1.0f);
    EXPECT_EQ(stain.wetness(), 1.0f);
    float run = 0.0f, opacity = 1.0f, wetness = 1.0f;
    for (int i = 1; i <= 60; ++i) {
        stain.age = 0.1f * static_cast<float>(i);
        EXPECT_EQ(stain.spread(), 1.0f);
        EXPECT_GE(stain.run(), run);
        EXPECT_LE(stain.opacity(), opacity);
        EXPECT_LE(stain.wetness(), wetness);
        wetness = stain.wetness();
        run = stain.run();
        opacity = stain.opacity();
    }
    EXPECT_GT(run, 0.3f);
    EXPECT_LT(run, 2.0f);
    EXPECT_LT(opacity, 1e-3f);
    EXPECT_EQ(wetness, 0.0f);
}

TEST(Stains, AreGoneAfterTheirLife)
{
    Stains stains;
    stains.add({});
    for (int i = 0; i < 59; ++i) stains.advance(0.1f);
    EXPECT_EQ(stains.all().size(), 1u);
    for (int i = 0; i < 2; ++i) stains.advance(0.1f);
    EXPECT_TRUE(stains.all().empty());
}

TEST(Stains, TheOldestMakeRoom)
{
    Stains stains;
    for (std::size_t i = 0; i < Stains::kMost + 10; ++i) {
        Stain stain;
        stain.size = static_cast<float>(i);
        stains.add(stain);
    }
    EXPECT_EQ(stains.all().size(), Stains::kMost);
    EXPECT_EQ(stains.all().front().size, 10.0f);
}

}  // namespace kerf::test
