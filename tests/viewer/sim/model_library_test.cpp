#include "viewer/sim/model_library.h"

#include <kerf/io.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <thread>

#include "common/files/file_error.h"
#include "support/temporary_folder.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/sim/surface_hash.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

TEST(ModelLibrary, HoldsTheReportsFifteenModelsInItsOrder)
{
    const auto library = test::report_library();
    ASSERT_EQ(library->size(), 15u);
    EXPECT_EQ(library->model(0).name, "car");
    EXPECT_EQ(library->model(14).name, "monkey");
    EXPECT_EQ(library->model(2).files.front(), KERF_DATA_DIR "/models/rook.obj");
}

TEST(ModelLibrary, AFileThatIsNoMeshIsAnErrorAndLeavesTheLibraryAsItWas)
{
    ModelLibrary library;
    EXPECT_THROW(library.add_file("/nowhere/at/all.obj"), core::io::FileError);
    EXPECT_TRUE(library.empty());
}

TEST(ModelLibrary, KnowsWhichFilesHaveABoundary)
{
    const Mesh box = test::shape("box");
    MeshInput lidless = test::input_of(box);
    --lidless.triangle_count;
    const test::TemporaryFolder folder;
    const std::filesystem::path closed = folder.file("closed.ply"), open = folder.file("open.ply");
    ASSERT_TRUE(write_mesh(box, closed.c_str()));
    ASSERT_TRUE(write_mesh(test::value_of(Mesh::make(lidless)), open.c_str()));
    ModelLibrary library;
    EXPECT_TRUE(library.model(library.add_file(closed)).is_closed);
    EXPECT_FALSE(library.model(library.add_file(open)).is_closed);
}

TEST(ModelLibrary, PreparesOnceAndHandsOutIndependentCopies)
{
    const auto library = test::library_of({"asteroid"});
    for (const std::string& backend : backend_names()) {
        EXPECT_FALSE(library->is_prepared(0, backend));
        const Object one = library->make(0, backend), two = library->make(0, backend);
        EXPECT_TRUE(library->is_prepared(0, backend));
        ASSERT_TRUE(one && two);
        EXPECT_NE(test::view_of(one).buffers, test::view_of(two).buffers);
        EXPECT_EQ(one.triangle_count(), two.triangle_count());
    }
}

TEST(ModelLibrary, SaysWhyAMeshCannotBePrepared)
{
    ModelLibrary library;
    library.add("broken", Mesh());
    EXPECT_TRUE(library.make(0, backend_names().front()).is_empty());
    EXPECT_NE(library.prepare(0, backend_names().front()).find("broken can't be prepared: "), std::string::npos);
    EXPECT_NE(library.prepare(0, "axe"), "");
}

TEST(ModelLibrary, SeveralThreadsMayAskAtOnce)
{
    const auto library = test::library_of({"asteroid", "torus"});
    std::vector<std::thread> threads;
    std::vector<Object> made(4);
    for (std::size_t i = 0; i < made.size(); ++i)
        threads.emplace_back([&, i] { made[i] = library->make(i % 2, backend_names().front()); });
    for (std::thread& thread : threads) thread.join();
    for (const Object& object : made) EXPECT_TRUE(object);
}

TEST(ModelLibrary, WhatIsStockedIsHandedOutOnceAndEqualsACopy)
{
    const auto library = test::library_of({"asteroid"});
    const std::string& backend = backend_names().front();
    library->stock(0, backend);
    library->stock(0, backend);
    const Object stocked = library->make(0, backend), copy = library->make(0, backend);
    ASSERT_TRUE(stocked && copy);
    EXPECT_NE(test::view_of(stocked).buffers, test::view_of(copy).buffers);
    EXPECT_EQ(surface_hash(stocked), surface_hash(copy));
}

TEST(ModelLibrary, HandsOutACopyWithItsMeasures)
{
    const auto library = test::library_of({"torus"});
    for (const std::string& backend : backend_names()) {
        for (const ProxyKind kind : {ProxyKind::bounded_hull, ProxyKind::box}) {
            const Throwable taken = library->take(0, backend, kind);
            ASSERT_TRUE(taken.object);
            const MassProperties mass = taken.object.mass_properties();
            EXPECT_EQ(taken.mass.volume, mass.volume);
            EXPECT_EQ(taken.mass.centre, mass.centre);
            EXPECT_EQ(to_glm(taken.mass.inertia), to_glm(mass.inertia));
            EXPECT_EQ(taken.bounds.lo, taken.object.bounds().lo);
            EXPECT_EQ(taken.bounds.hi, taken.object.bounds().hi);
            const CollisionProxy proxy = body_proxy(taken.object, kind);
            EXPECT_EQ(taken.proxy->kind, kind);
            EXPECT_EQ(taken.proxy->points, proxy.points);
            ASSERT_EQ(taken.proxy->hull != nullptr, kind == ProxyKind::bounded_hull);
            if (proxy.hull) {
                EXPECT_TRUE(std::ranges::equal(taken.proxy->hull->indices(), proxy.hull->indices()));
            }
        }
    }
}

TEST(ModelLibrary, CountsWhatHadToBeDoneWhenItWasTaken)
{
    const auto library = test::library_of({"icosphere", "box"});
    const std::string& backend = backend_names().front();
    const auto expect_late = [&](std::uint64_t preparations, std::uint64_t copies) {
        EXPECT_EQ(library->late_work().preparations, preparations);
        EXPECT_EQ(library->late_work().copies, copies);
    };
    library->stock(0, backend);
    EXPECT_TRUE(library->is_stocked(0, backend));
    EXPECT_FALSE(library->is_stocked(0, backend, ProxyKind::box)) << "its measures are another matter";
    EXPECT_FALSE(library->is_stocked(1, backend));
    ASSERT_TRUE(library->stocked(0, backend));
    const std::uint64_t number = library->stocked(0, backend)->copy;
    const Throwable stocked = library->take(0, backend);
    EXPECT_EQ(stocked.copy, number);
    EXPECT_FALSE(library->stocked(0, backend));
    expect_late(0, 0);
    EXPECT_NE(library->take(0, backend).copy, number);
    expect_late(0, 1);
    library->take(1, backend);
    expect_late(1, 2);
}

TEST(ModelLibrary, WhatCannotBePreparedNeedsNoStock)
{
    ModelLibrary library;
    library.add("broken", Mesh());
    library.stock(0, backend_names().front());
    EXPECT_TRUE(library.is_stocked(0, backend_names().front()));
    EXPECT_FALSE(library.stocked(0, backend_names().front()));
    EXPECT_FALSE(library.take(0, backend_names().front()).object);
}

TEST(ModelLibrary, AModelMayBeEmptiedWhileItIsBeingStocked)
{
    const auto library = test::library_of({"asteroid"}, 200'000);
    const std::string& backend = backend_names().front();
    library->prepare(0, backend);
    std::thread worker([&] { library->stock(0, backend); });
    library->empty_model(0);
    worker.join();
    EXPECT_EQ(library->model(0).mesh.triangle_count(), 0u);
}

TEST(ModelLibrary, PreparingABigMeshHoldsUpNobodyWhoWantsAnother)
{
    auto library = test::library_of({"icosphere"});
    const std::size_t big = library->add("asteroid", test::shape("asteroid", 400'000));
    const std::string& backend = backend_names().front();
    std::atomic<bool> started = false;
    std::thread worker([&] {
        started = true;
        library->prepare(big, backend);
    });
    while (!started) std::this_thread::yield();
    int made = 0;
    // Preparing takes a tenth of a second and more; a frame's throws go on meanwhile.
    while (!library->is_prepared(big, backend)) {
        ASSERT_TRUE(library->make(0, backend));
        ASSERT_EQ(library->model(0).name, "icosphere");
        ++made;
    }
    worker.join();
    EXPECT_GE(made, 3);
}

TEST(BackEnds, AreFoundByName)
{
    for (const std::string& name : backend_names())
        EXPECT_EQ(test::object_of(test::shape("box"), name).back_end_name(), name);
    EXPECT_EQ(known_back_end("baseline"), "baseline/hash");
    EXPECT_EQ(known_back_end("axe"), "");
    EXPECT_EQ(prepare(test::shape("box"), "axe").status(), Status::invalid_argument);
}

}  // namespace
}  // namespace kerf::sim
