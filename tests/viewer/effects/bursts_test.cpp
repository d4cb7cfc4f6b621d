#include "viewer/effects/bursts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace kerf::test {

using effects::Drop;
using effects::Drops;
using effects::Splash;
using effects::Stains;

namespace {

/// A cut through a ball at (1, 2, 0), seen by its outline.
Splash ball_cut(std::uint64_t seed)
{
    Splash splash;
    splash.seed = seed;
    splash.centre = {1.0f, 2.0f, 0.0f};
    splash.behind = {1.3f, 2.5f};
    splash.size = 0.8f;
    splash.normal = {0.0f, 1.0f, 0.0f};
    splash.colour = {0.8f, 0.1f, 0.1f};
    for (int i = 0; i < 40; ++i) {
        const float angle = 0.157f * static_cast<float>(i);
        splash.outline.push_back(splash.centre + 0.8f * glm::vec3(std::cos(angle), 0.0f, std::sin(angle)));
    }
    return splash;
}

std::vector<glm::vec3> places(const Drops& drops)
{
    std::vector<glm::vec3> result;
    for (const Drop& drop : drops.all()) result.push_back(drop.place);
    return result;
}

}  // namespace

TEST(Splash, LeavesFromTheSectionToBothSides)
{
    Drops drops;
    Stains stains;
    add_splash(ball_cut(1), drops, stains);
    ASSERT_GT(drops.all().size(), 30u);
    int up = 0, down = 0;
    for (const Drop& drop : drops.all()) {
        EXPECT_NEAR(drop.place.y, 2.0f, 1e-5f) << "on the section";
        EXPECT_LE(glm::length(drop.place - glm::vec3(1.0f, 2.0f, 0.0f)), 0.81f);
        (drop.velocity.y > 0.0f ? up : down) += 1;
    }
    EXPECT_GT(up, 10);
    EXPECT_GT(down, 10);
}

TEST(Splash, IsDropsOfManySizesInALittleMist)
{
    Drops drops;
    Stains stains;
    add_splash(ball_cut(1), drops, stains);
    float least = 1.0f, most = 0.0f;
    std::size_t mist = 0;
    for (const Drop& drop : drops.all()) {
        if (drop.kind == effects::DropKind::mist) {
            ++mist;
            continue;
        }
        least = std::min(least, drop.size);
        most = std::max(most, drop.size);
    }
    EXPECT_GT(most, 5.0f * least);
    EXPECT_GT(mist, 0u);
    EXPECT_LT(10 * mist, drops.all().size());
}

TEST(Splash, LeavesAStainBehindTheFruit)
{
    Drops drops;
    Stains stains;
    add_splash(ball_cut(1), drops, stains);
    ASSERT_EQ(stains.all().size(), 1u);
    EXPECT_LT(glm::length(stains.all()[0].place - glm::vec2(1.3f, 2.5f)), 0.5f);
    EXPECT_EQ(stains.all()[0].colour, ball_cut(1).colour);
}

TEST(Splash, OfSomethingDryIsNone)
{
    Drops drops;
    Stains stains;
    Splash dry = ball_cut(1);
    dry.strength = 0.0f;
    add_splash(dry, drops, stains);
    EXPECT_TRUE(drops.all().empty());
    EXPECT_TRUE(stains.all().empty());
}

TEST(Splash, IsTheSameForTheSameSeedOnly)
{
    Drops first, second, third;
    Stains stains;
    add_splash(ball_cut(7), first, stains);
    add_splash(ball_cut(7), second, stains);
    add_splash(ball_cut(8), third, stains);
    EXPECT_EQ(places(first), places(second));
    EXPECT_NE(places(first), places(third));
}

TEST(Splash, OfAThousandCutsStaysBounded)
{
    Drops drops;
    Stains stains;
    std::vector<effects::WallHit> hits;
    for (std::uint64_t i = 0; i < 1000; ++i) {
        add_splash(ball_cut(i), drops, stains);
        add_explosion({0.0f, 0.0f, 0.0f}, i, drops);
        add_sparkle({0.0f, 0.0f, 0.0f}, glm::vec3(1.0f), i, drops);
        add_fuse_sparks({0.0f, 0.0f, 0.0f}, i, drops);
        drops.advance(1.0f / 120.0f, hits);
        ASSERT_LE(drops.all().size(), Drops::kMost);
        ASSERT_LE(stains.all().size(), Stains::kMost);
    }
    for (int i = 0; i < 400; ++i) drops.advance(1.0f / 120.0f, hits);
    EXPECT_TRUE(drops.all().empty()) << "nothing lasts for ever";
}

}  // namespace kerf::test
