#include "viewer/sim/model_shelf.h"

#include <gtest/gtest.h>

#include <unistd.h>

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

TEST(ModelShelf, KnowsWhichFilesHaveABoundary)
{
    IndexedMesh lidless = *test::shape("box");
    lidless.triangles.pop_back();
    --lidless.groups.back().count;
    if (!lidless.sources.empty()) lidless.sources.pop_back();
    const std::filesystem::path folder = std::filesystem::temp_directory_path();
    const auto closed = folder / ("kerf_closed_" + std::to_string(::getpid()) + ".ply");
    const auto open = folder / ("kerf_open_" + std::to_string(::getpid()) + ".ply");
    io::write_mesh(closed, *test::shape("box"));
    io::write_mesh(open, lidless);
    ModelShelf shelf;
    EXPECT_TRUE(shelf.model(shelf.add_file(closed)).is_closed);
    EXPECT_FALSE(shelf.model(shelf.add_file(open)).is_closed);
    std::filesystem::remove(closed);
    std::filesystem::remove(open);
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
    ModelShelf shelf;
    shelf.add("broken", ProvenMesh());
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

TEST(ModelShelf, HandsOutACopyWithItsMeasures)
{
    const auto shelf = test::shelf_of({"torus"});
    for (const std::string& backend : backend_names()) {
        for (const ProxyKind kind : {ProxyKind::bounded_hull, ProxyKind::box}) {
            const Throwable taken = shelf->take(0, backend, kind);
            ASSERT_TRUE(taken.object);
            const MassProperties mass = taken.object->mass_properties();
            EXPECT_EQ(taken.mass.volume, mass.volume);
            EXPECT_EQ(taken.mass.centre, mass.centre);
            EXPECT_EQ(taken.mass.inertia, mass.inertia);
            EXPECT_EQ(taken.bounds.lo, taken.object->bounds().lo);
            EXPECT_EQ(taken.bounds.hi, taken.object->bounds().hi);
            const CollisionProxy proxy = taken.object->collision_proxy(kind);
            EXPECT_EQ(taken.proxy->kind, kind);
            EXPECT_EQ(taken.proxy->points, proxy.points);
            EXPECT_EQ(taken.proxy->faces, proxy.faces);
        }
    }
}

TEST(ModelShelf, CountsWhatHadToBeDoneWhenItWasTaken)
{
    const auto shelf = test::shelf_of({"icosphere", "box"});
    const std::string& backend = backend_names().front();
    const auto expect_late = [&](std::uint64_t preparations, std::uint64_t copies) {
        EXPECT_EQ(shelf->late_work().preparations, preparations);
        EXPECT_EQ(shelf->late_work().copies, copies);
    };
    shelf->stock(0, backend);
    EXPECT_TRUE(shelf->is_stocked(0, backend));
    EXPECT_FALSE(shelf->is_stocked(0, backend, ProxyKind::box)) << "its measures are another matter";
    EXPECT_FALSE(shelf->is_stocked(1, backend));
    ASSERT_TRUE(shelf->stocked(0, backend));
    const std::uint64_t number = shelf->stocked(0, backend)->copy;
    const Throwable stocked = shelf->take(0, backend);
    EXPECT_EQ(stocked.copy, number);
    EXPECT_FALSE(shelf->stocked(0, backend));
    expect_late(0, 0);
    EXPECT_NE(shelf->take(0, backend).copy, number);
    expect_late(0, 1);
    shelf->take(1, backend);
    expect_late(1, 2);
}

TEST(ModelShelf, WhatCannotBePreparedNeedsNoStock)
{
    ModelShelf shelf;
    shelf.add("broken", ProvenMesh());
    shelf.stock(0, backend_names().front());
    EXPECT_TRUE(shelf.is_stocked(0, backend_names().front()));
    EXPECT_FALSE(shelf.stocked(0, backend_names().front()));
    EXPECT_FALSE(shelf.take(0, backend_names().front()).object);
}

TEST(ModelShelf, AModelMayBeEmptiedWhileItIsBeingStocked)
{
    const auto shelf = test::shelf_of({"asteroid"}, 200'000);
    const std::string& backend = backend_names().front();
    shelf->prepare(0, backend);
    std::thread worker([&] { shelf->stock(0, backend); });
    shelf->empty_model(0);
    worker.join();
    EXPECT_EQ(shelf->model(0).mesh->triangles.size(), 0u);
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
