#include "viewer/game/giant_maker.h"

#include <gtest/gtest.h>

#include "viewer/game/giant_sizes.h"
#include "viewer/sim/back_ends.h"

namespace kerf::game {
namespace {

const std::string& backend()
{
    return sim::backend_names().front();
}

}  // namespace

TEST(GiantMaker, DoesNothingUnasked)
{
    GiantMaker maker(std::make_shared<sim::ModelLibrary>());
    EXPECT_EQ(maker.stage(), GiantStage::idle);
    EXPECT_FALSE(maker.is_done());
    maker.wait();
}

TEST(GiantMaker, PutsAnAsteroidIntoTheLibrary)
{
    const auto models = std::make_shared<sim::ModelLibrary>();
    GiantMaker maker(models);
    maker.request(20'000, 3, backend());
    maker.wait();
    ASSERT_EQ(maker.stage(), GiantStage::ready);
    EXPECT_EQ(maker.progress(), 1.0);
    EXPECT_TRUE(models->is_prepared(maker.model(), backend()));
    EXPECT_NEAR(double(models->make(maker.model(), backend()).triangle_count()), 20'000.0, 1000.0);
}

TEST(GiantMaker, MakesASizeOnlyOnce)
{
    const auto models = std::make_shared<sim::ModelLibrary>();
    GiantMaker maker(models);
    for (int i = 0; i < 3; ++i) {
        maker.request(10'000, 1, backend());
        maker.wait();
        ASSERT_EQ(maker.stage(), GiantStage::ready);
    }
    EXPECT_EQ(models->size(), 1u);
    EXPECT_EQ(maker.model(), 0u);
}

TEST(GiantMaker, KeepsTheLastSizeOnly)
{
    const auto models = std::make_shared<sim::ModelLibrary>();
    {
        GiantMaker maker(models);
        for (const std::int64_t triangles : {10'000, 12'000, 14'000}) {
            maker.request(triangles, 1, backend());
            maker.wait();
        }
        ASSERT_EQ(models->size(), 3u);
        EXPECT_EQ(models->model(0).mesh.triangle_count(), 0u);
        EXPECT_EQ(models->model(1).mesh.triangle_count(), 0u);
        EXPECT_GT(models->model(2).mesh.triangle_count(), 13'000u);
        EXPECT_GT(models->model(0).box.hi.x, 0.1f) << "boxes stay: pieces in the air are measured by them";
    }
    EXPECT_EQ(models->model(2).mesh.triangle_count(), 0u);
}

TEST(GiantMaker, GivesUpWhatNobodyWantsAnyMore)
{
    const auto models = std::make_shared<sim::ModelLibrary>();
    {
        GiantMaker maker(models);
        for (std::int64_t triangles = 300'000; triangles < 308'000; triangles += 1000)
            maker.request(triangles, 1, backend());
        maker.request(10'000, 1, backend());
        maker.wait();
        ASSERT_EQ(maker.stage(), GiantStage::ready);
        EXPECT_LT(models->model(maker.model()).mesh.triangle_count(), 12'000u);
        maker.request(500'000, 1, backend());
    }
    SUCCEED() << "it ends while its threads are still at work";
}

TEST(GiantMaker, SaysWhatItCannotDo)
{
    GiantMaker maker(std::make_shared<sim::ModelLibrary>());
    maker.request(10'000, 1, "axe");
    maker.wait();
    EXPECT_EQ(maker.stage(), GiantStage::failed);
    EXPECT_NE(maker.error().find("axe"), std::string::npos) << maker.error();
}

}  // namespace kerf::game
