#include "viewer/sim/stocker.h"

#include <gtest/gtest.h>

#include "viewer/sim/back_ends.h"
#include "viewer/sim/stages.h"

namespace kerf::sim {
namespace {

const std::string& backend()
{
    return backend_names().front();
}

/// A run of the report scene, in which every throw finds its copy or, without a stocker, makes it.
std::uint64_t hash_of_run(const std::shared_ptr<ModelShelf>& models, Stocker* stocker)
{
    Simulation simulation(models, {});
    for (int frame = 0; frame < 400; ++frame) {
        if (stocker != nullptr) {
            stocker->want(simulation.scene().next_models(), simulation.backend(), simulation.proxy());
            stocker->finish();
        }
        if (frame == 60 || frame == 200)
            simulation.push(test::stroke(simulation.time() + 1, 90'000, {-6.0, 1.0}, {6.0, 1.4}));
        simulation.advance(kTicksPerFrame);
    }
    return simulation.state_hash();
}

}  // namespace

TEST(Stocker, StocksWhatIsWanted)
{
    const auto models = test::shelf_of({"icosphere", "box", "torus"});
    Stocker stocker(models);
    stocker.finish();
    stocker.want({2, 0}, backend(), ProxyKind::box);
    stocker.finish();
    EXPECT_TRUE(models->is_stocked(0, backend(), ProxyKind::box));
    EXPECT_FALSE(models->is_stocked(1, backend(), ProxyKind::box));
    EXPECT_TRUE(models->is_stocked(2, backend(), ProxyKind::box));
}

TEST(Stocker, PutsAnotherCopyWhereOneWasTaken)
{
    const auto models = test::shelf_of({"icosphere"});
    Stocker stocker(models);
    std::uint64_t last = 0;
    for (int i = 0; i < 5; ++i) {
        stocker.want({0}, backend(), ProxyKind::bounded_hull);
        stocker.finish();
        const Throwable taken = models->take(0, backend());
        EXPECT_NE(taken.copy, last);
        last = taken.copy;
    }
    EXPECT_EQ(models->late_work().preparations, 0u);
    EXPECT_EQ(models->late_work().copies, 0u);
}

TEST(Stocker, ForgetsWhatIsNoLongerWanted)
{
    const auto models = test::shelf_of({"asteroid", "torus", "box"}, 60'000);
    Stocker stocker(models);
    stocker.want({0, 1}, backend(), ProxyKind::bounded_hull);
    stocker.want({2}, backend(), ProxyKind::bounded_hull);
    stocker.finish();
    EXPECT_TRUE(models->is_stocked(2, backend()));
    EXPECT_FALSE(models->is_prepared(1, backend())) << "the second wish of the first list";
}

TEST(Stocker, WhoeverNeedsACopyEarlierWaitsForIt)
{
    const auto models = test::shelf_of({"asteroid"}, 100'000);
    Stocker stocker(models);
    stocker.want({0}, backend(), ProxyKind::bounded_hull);
    EXPECT_TRUE(models->take(0, backend()).object);
}

TEST(Stocker, EndsWhileItIsAtWork)
{
    const auto models = test::shelf_of({"asteroid", "torus"}, 100'000);
    Stocker stocker(models);
    stocker.want({0, 1}, backend(), ProxyKind::bounded_hull);
}

TEST(Stocker, SparesTicksTheirPreparingAndChangesNothingOfARun)
{
    const auto models = test::shelf_of({"icosphere", "torus", "box"});
    Stocker stocker(models);
    const std::uint64_t stocked = hash_of_run(models, &stocker);
    EXPECT_EQ(models->late_work().preparations, 0u);
    EXPECT_EQ(models->late_work().copies, 0u);

    const auto others = test::shelf_of({"icosphere", "torus", "box"});
    EXPECT_EQ(hash_of_run(others, nullptr), stocked);
    EXPECT_EQ(others->late_work().preparations, 3u);
}

}  // namespace kerf::sim
