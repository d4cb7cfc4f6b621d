#include "viewer/sim/model_shelf.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "common/io/mesh_file.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/stages.h"
#include "viewer/sim/surface_hash.h"

namespace kerf::sim {
namespace {

TEST(ModelShelf, HoldsTheReportsFifteenModelsInItsOrder)
{
    const auto shelf = test::report_shelf();
    ASSERT_EQ(shelf->size(), 15u);
    EXPECT_EQ(shelf->model(0).name, "car");
    EXPECT_EQ(shelf->model(14).name, "monkey");
    EXPECT_EQ(shelf->model(2).folder, KERF_DATA_DIR "/models");
}

TEST(ModelShelf, AFileThatIsNoMeshIsAnErrorAndLeavesTheShelfAsItWas)
{
    ModelShelf shelf;
    EXPECT_THROW(shelf.add_file("/nowhere/at/all.obj"), io::FileError);
    EXPECT_TRUE(shelf.empty());
}

TEST(ModelShelf, PreparesOnceAndHandsOutIndependentCopies)
{
    const auto shelf = test::shelf_of({"asteroid"});
    for (const std::string& backend : backend_names()) {
        EXPECT_FALSE(shelf->is_prepared(0, backend));
        const auto one = shelf->make(0, backend), two = shelf->make(0, backend);
        EXPECT_TRUE(shelf->is_prepared(0, backend));
        ASSERT_TRUE(one && two);
        EXPECT_NE(one->draw_view().buffers, two->draw_view().buffers);
        EXPECT_EQ(one->triangle_count(), two->triangle_count());
    }
}

TEST(ModelShelf, SaysWhyAMeshCannotBePrepared)
{
    IndexedMesh broken = test::shape("box");
    broken.triangles[0][0] = 4'000'000'000u;
    ModelShelf shelf;
    shelf.add("broken", std::move(broken));
    EXPECT_EQ(shelf.make(0, backend_names().front()), nullptr);
    EXPECT_NE(shelf.prepare(0, backend_names().front()).find("broken can't be prepared: "), std::string::npos);
    EXPECT_NE(shelf.prepare(0, "axe"), "");
}

TEST(ModelShelf, SeveralThreadsMayAskAtOnce)
{
    const auto shelf = test::shelf_of({"asteroid", "torus"});
    std::vector<std::thread> threads;
    std::vector<std::unique_ptr<Cuttable>> made(4);
    for (std::size_t i = 0; i < made.size(); ++i)
        threads.emplace_back([&, i] { made[i] = shelf->make(i % 2, backend_names().front()); });
    for (std::thread& thread : threads) thread.join();
    for (const auto& object : made) EXPECT_TRUE(object);
}

TEST(ModelShelf, WhatIsStockedIsHandedOutOnceAndEqualsACopy)
{
    const auto shelf = test::shelf_of({"asteroid"});
    const std::string& backend = backend_names().front();
    shelf->stock(0, backend);
    shelf->stock(0, backend);
    const auto stocked = shelf->make(0, backend), copy = shelf->make(0, backend);
    ASSERT_TRUE(stocked && copy);
    EXPECT_NE(stocked->draw_view().buffers, copy->draw_view().buffers);
    EXPECT_EQ(surface_hash(*stocked), surface_hash(*copy));
}

TEST(ModelShelf, PreparingABigMeshHoldsUpNobodyWhoWantsAnother)
{
    auto shelf = test::shelf_of({"icosphere"});
    const std::size_t big = shelf->add("asteroid", test::shape("asteroid", 400'000));
    const std::string& backend = backend_names().front();
    std::atomic<bool> started = false;
    std::thread worker([&] {
        started = true;
        shelf->prepare(big, backend);
    });
    while (!started) std::this_thread::yield();
    int made = 0;
    // Preparing takes a tenth of a second and more; a frame's throws go on meanwhile.
    while (!shelf->is_prepared(big, backend)) {
        ASSERT_TRUE(shelf->make(0, backend));
        ASSERT_EQ(shelf->model(0).name, "icosphere");
        ++made;
    }
    worker.join();
    EXPECT_GE(made, 3);
}

TEST(BackEnds, AreFoundByName)
{
    for (const std::string& name : backend_names()) EXPECT_EQ(make_backend(name)->name(), name);
    EXPECT_EQ(find_backend("baseline"), "baseline/hash");
    EXPECT_EQ(find_backend("axe"), "");
    EXPECT_EQ(make_backend("axe"), nullptr);
}

}  // namespace
}  // namespace kerf::sim
