#include "viewer/effects/drops.h"

#include <gtest/gtest.h>

namespace kerf::test {

using effects::Drop;
using effects::DropKind;
using effects::Drops;
using effects::WallHit;

namespace {

constexpr float kStep = 1.0f / 120.0f;

}  // namespace

TEST(Drops, FallAsThingsDo)
{
    Drops drops;
    Drop drop;
    drop.velocity = {0.0f, 3.0f, 0.0f};
    drop.life = 10.0f;
    drops.add(drop);
    std::vector<WallHit> hits;
    for (int i = 0; i < 60; ++i) drops.advance(kStep, hits);
    ASSERT_EQ(drops.all().size(), 1u);
    // After half a second 3 t - g t^2 / 2 is 0.27 m in the vacuum; the air takes a little.
    EXPECT_NEAR(drops.all()[0].place.y, 0.27f, 0.2f);
    EXPECT_LT(drops.all()[0].velocity.y, -1.0f);
    EXPECT_TRUE(hits.empty());
}

TEST(Drops, OfJuiceEndOnTheWallAndSayWhere)
{
    Drops drops;
    Drop drop;
    drop.place = {1.0f, 2.0f, effects::kWallZ + 0.01f};
    drop.velocity = {0.0f, 0.0f, -5.0f};
    drop.colour = {0.7f, 0.1f, 0.1f};
    drops.add(drop);
    std::vector<WallHit> hits;
    drops.advance(kStep, hits);
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].place.x, 1.0f, 1e-3f);
    EXPECT_EQ(hits[0].place.z, effects::kWallZ);
    EXPECT_EQ(hits[0].colour, drop.colour);
    EXPECT_TRUE(drops.all().empty());
}

TEST(Drops, OfSmokeRiseAndStayBeforeTheWall)
{
    Drops drops;
    Drop drop;
    drop.kind = DropKind::smoke;
    drop.velocity = {0.0f, 0.0f, -50.0f};
    drops.add(drop);
    std::vector<WallHit> hits;
    for (int i = 0; i < 60; ++i) drops.advance(kStep, hits);
    ASSERT_EQ(drops.all().size(), 1u);
    EXPECT_GT(drops.all()[0].place.y, 0.0f);
    EXPECT_GT(drops.all()[0].place.z, effects::kWallZ);
    EXPECT_GT(drops.all()[0].size, drop.size);
    EXPECT_TRUE(hits.empty());
}

TEST(Drops, VanishWhenTheirLifeIsOver)
{
    Drops drops;
    Drop drop;
    drop.life = 0.1f;
    drops.add(drop);
    std::vector<WallHit> hits;
    for (int i = 0; i < 13; ++i) drops.advance(kStep, hits);
    EXPECT_TRUE(drops.all().empty());
}

TEST(Drops, AreNeverMoreThanTheirBound)
{
    Drops drops;
    Drop drop;
    drop.life = 1e6f;
    for (std::size_t i = 0; i < 3 * Drops::kMost; ++i) {
        drop.size = 1.0f + static_cast<float>(i);
        drops.add(drop);
    }
    EXPECT_EQ(drops.all().size(), Drops::kMost);
    // The latest are kept.
    float least = 1e9f;
    for (const Drop& kept : drops.all()) least = std::min(least, kept.size);
    EXPECT_EQ(least, 1.0f + static_cast<float>(2 * Drops::kMost));
}

}  // namespace kerf::test
