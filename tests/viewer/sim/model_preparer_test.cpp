#include "viewer/sim/model_preparer.h"

#include <gtest/gtest.h>

#include "viewer/sim/back_ends.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

const std::string& backend()
{
    return backend_names().front();
}

/// A run of the report scene, in which every throw finds its copy or, without a preparer, makes it.
std::uint64_t hash_of_run(const std::shared_ptr<ModelLibrary>& models, ModelPreparer* preparer)
{
    Simulation simulation(models, {});
    for (int frame = 0; frame < 400; ++frame) {
        if (preparer != nullptr) {
            preparer->want(simulation.scene().next_models(), simulation.backend(), simulation.proxy());
            preparer->finish();
        }
        if (frame == 60 || frame == 200)
            simulation.push(test::stroke(simulation.time() + 1, 90'000, {-6.0, 1.0}, {6.0, 1.4}));
        simulation.advance(kTicksPerFrame);
    }
    return simulation.state_hash();
}

}  // namespace

TEST(ModelPreparer, StocksWhatIsWanted)
{
    const auto models = test::library_of({"icosphere", "box", "torus"});
    ModelPreparer preparer(models);
    preparer.finish();
    preparer.want({2, 0}, backend(), ProxyKind::box);
    preparer.finish();
    EXPECT_TRUE(models->is_stocked(0, backend(), ProxyKind::box));
    EXPECT_FALSE(models->is_stocked(1, backend(), ProxyKind::box));
    EXPECT_TRUE(models->is_stocked(2, backend(), ProxyKind::box));
}

TEST(ModelPreparer, PutsAnotherCopyWhereOneWasTaken)
{
    const auto models = test::library_of({"icosphere"});
    ModelPreparer preparer(models);
    std::uint64_t last = 0;
    for (int i = 0; i < 5; ++i) {
        preparer.want({0}, backend(), ProxyKind::bounded_hull);
        preparer.finish();
        const Throwable taken = models->take(0, backend());
        EXPECT_NE(taken.copy, last);
        last = taken.copy;
    }
    EXPECT_EQ(models->late_work().preparations, 0u);
    EXPECT_EQ(models->late_work().copies, 0u);
}

TEST(ModelPreparer, ForgetsWhatIsNoLongerWanted)
{
    // If this thread has to wait between the two lists, the second wish of the first one may be done by then: once more.
    constexpr int kMostTries = 50;
    bool has_forgotten = false;
    for (int i = 0; i < kMostTries && !has_forgotten; ++i) {
        const auto models = test::library_of({"asteroid", "torus", "box"}, 60'000);
        ModelPreparer preparer(models);
        preparer.want({0, 1}, backend(), ProxyKind::bounded_hull);
        preparer.want({2}, backend(), ProxyKind::bounded_hull);
        preparer.finish();
        ASSERT_TRUE(models->is_stocked(2, backend()));
        has_forgotten = !models->is_prepared(1, backend());
    }
    EXPECT_TRUE(has_forgotten);
}

TEST(ModelPreparer, WhoeverNeedsACopyEarlierWaitsForIt)
{
    const auto models = test::library_of({"asteroid"}, 100'000);
    ModelPreparer preparer(models);
    preparer.want({0}, backend(), ProxyKind::bounded_hull);
    EXPECT_TRUE(models->take(0, backend()).object);
}

TEST(ModelPreparer, EndsWhileItIsAtWork)
{
    const auto models = test::library_of({"asteroid", "torus"}, 100'000);
    ModelPreparer preparer(models);
    preparer.want({0, 1}, backend(), ProxyKind::bounded_hull);
}

TEST(ModelPreparer, SparesTicksTheirPreparingAndChangesNothingOfARun)
{
    const auto models = test::library_of({"icosphere", "torus", "box"});
    ModelPreparer preparer(models);
    const std::uint64_t stocked = hash_of_run(models, &preparer);
    EXPECT_EQ(models->late_work().preparations, 0u);
    EXPECT_EQ(models->late_work().copies, 0u);

    const auto others = test::library_of({"icosphere", "torus", "box"});
    EXPECT_EQ(hash_of_run(others, nullptr), stocked);
    EXPECT_EQ(others->late_work().preparations, 3u);
}

}  // namespace kerf::sim
