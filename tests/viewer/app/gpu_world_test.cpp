#include "viewer/app/gpu_world.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "viewer/game/autopilot.h"
#include "viewer/game/scenes.h"
#include "viewer/render/gl_test.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/camera.h"
#include "viewer/support/stages.h"

namespace kerf::test {

namespace {

class GpuWorldTest : public GlTest, public ::testing::WithParamInterface<std::string>
{
protected:
    sim::Simulation simulation{library_of({"torus", "box", "asteroid"}, 2000), settings()};
    render::LookTable looks;
    app::GpuWorld world{looks};

    static sim::Settings settings()
    {
        sim::Settings settings;
        settings.backend = GetParam();
        settings.seed = 4;
        return settings;
    }

    /// Plays until so many cuts have happened, and brings every tick, or every so many, onto the card.
    void play_until_cuts(std::size_t count, sim::Tick ticks = 1)
    {
        game::Autopilot autopilot(1);
        while (simulation.now() < 4000 && simulation.cuts().size() < count) {
            for (sim::Tick tick = 0; tick < ticks; ++tick) {
                simulation.push(autopilot.play(simulation));
                simulation.advance();
            }
            const std::size_t before = world.cut_uploads().size();
            world.sync(simulation);
            most_in_a_frame = std::max(most_in_a_frame, simulation.cuts().size() - before);
        }
        ASSERT_GE(simulation.cuts().size(), count);
    }

    std::uint64_t bytes_of_cuts() const
    {
        std::uint64_t sum = 0;
        for (const app::CutUpload& upload : world.cut_uploads()) sum += upload.bytes;
        return sum;
    }

    std::size_t most_in_a_frame = 0;  ///< cuts
};

INSTANTIATE_TEST_SUITE_P(BackEnds, GpuWorldTest, ::testing::Values("halfedge", "baseline/hash"),
                         [](const auto& param) { return param.param == "halfedge" ? "halfedge" : "baseline"; });

}  // namespace

TEST_P(GpuWorldTest, UploadsForEachCutWhatTheBackEndSaid)
{
    play_until_cuts(5);
    ASSERT_EQ(world.cut_uploads().size(), simulation.cuts().size());
    for (std::size_t i = 0; i < simulation.cuts().size(); ++i) {
        const sim::CutRecord& cut = simulation.cuts()[i];
        EXPECT_EQ(world.cut_uploads()[i].bytes, cut.statistics.bytes_to_upload) << "cut " << cut.number;
    }
}

TEST_P(GpuWorldTest, CountsForEachOfSeveralCutsInAFrameWhatItMade)
{
    play_until_cuts(25, sim::kTicksPerFrame);
    EXPECT_GE(most_in_a_frame, 2u) << "pieces of one object are cut in one frame";
    for (std::size_t i = 0; i < simulation.cuts().size(); ++i) {
        EXPECT_EQ(world.cut_uploads()[i].bytes, simulation.cuts()[i].statistics.bytes_to_upload) << i;
        EXPECT_GT(world.cut_uploads()[i].cpu_ms, 0.0) << i;
    }
    EXPECT_EQ(bytes_of_cuts() + world.bytes_of_throws(), world.store().bytes_uploaded());
}

TEST_P(GpuWorldTest, CountsWhatWasCutAgainBeforeItWasSeenOnceAtMost)
{
    play_until_cuts(25, 100);
    bool some_were_cut_again = false;
    for (std::size_t i = 0; i < simulation.cuts().size(); ++i) {
        const std::uint64_t made = simulation.cuts()[i].statistics.bytes_to_upload;
        EXPECT_LE(world.cut_uploads()[i].bytes, made) << i;
        some_were_cut_again = some_were_cut_again || world.cut_uploads()[i].bytes < made;
    }
    EXPECT_TRUE(some_were_cut_again);
    EXPECT_EQ(bytes_of_cuts() + world.bytes_of_throws(), world.store().bytes_uploaded());
}

TEST_P(GpuWorldTest, DrawsEveryBodyAndNothingElse)
{
    play_until_cuts(3);
    const auto objects = world.objects(simulation);
    ASSERT_EQ(objects.size(), simulation.bodies().size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        EXPECT_EQ(objects[i].id, simulation.bodies()[i]->id());
        EXPECT_EQ(objects[i].fragment->triangles, simulation.bodies()[i]->object().triangle_count());
    }
}

TEST_P(GpuWorldTest, HoldsNoMoreBuffersThanThereAreThrowsOrPieces)
{
    play_until_cuts(6);
    for (int tick = 0; tick < 600; ++tick) {
        simulation.advance();
        world.sync(simulation);
    }
    // After five seconds without a swipe all pieces have left; what flies now was thrown whole.
    EXPECT_LE(world.store().buffer_sets(), simulation.bodies().size());
}

// 400 000 triangles are more than 11 MB.
TEST_P(GpuWorldTest, AGiantComesBitByBitAndIsSeenWhenAllOfItIsThere)
{
    constexpr std::uint64_t kBudget = app::GpuWorld::kBytesInAFrame;
    const auto models = std::make_shared<sim::ModelLibrary>();
    sim::Simulation giant(models, settings(), game::make_scene("giant", models));
    giant.command("size 400000");
    std::vector<std::uint64_t> bytes;
    double share = 0.0;
    for (int frame = 0; frame < 10; ++frame) {
        giant.advance(sim::kTicksPerFrame);
        const std::uint64_t before = world.store().bytes_uploaded();
        world.sync(giant);
        bytes.push_back(world.store().bytes_uploaded() - before);
        EXPECT_LE(bytes.back(), kBudget);
        if (world.arriving()) {
            EXPECT_GT(*world.arriving(), share) << "in every frame some of it";
            share = *world.arriving();
        }
        EXPECT_EQ(world.objects(giant).size(), share == 1.0 ? 1u : 0u);
    }
    EXPECT_EQ(share, 1.0);
    EXPECT_FALSE(world.arriving());
    EXPECT_EQ(world.most_bytes_of_throws(), kBudget);
    const DrawView view = view_of(giant.bodies().front()->object());
    const std::uint64_t whole = view.vertices.size_bytes() + view.indices.size_bytes();
    EXPECT_GT(whole, 2 * kBudget);
    EXPECT_EQ(world.bytes_of_throws(), whole);
    EXPECT_EQ(std::uint64_t(std::count(bytes.begin(), bytes.end(), kBudget)), whole / kBudget);
}

TEST_P(GpuWorldTest, WhatIsThrownNextIsThereBeforeItsThrow)
{
    simulation.advance();
    world.sync(simulation);
    const std::size_t next = simulation.scene().next_models().front();
    simulation.models().stock(next, simulation.backend());
    world.sync(simulation);
    const std::uint64_t before = world.store().bytes_uploaded();
    EXPECT_EQ(world.bytes_of_throws(), before);
    simulation.command("throw");
    simulation.advance();
    ASSERT_EQ(simulation.bodies().size(), 2u);
    world.sync(simulation);
    EXPECT_EQ(world.store().bytes_uploaded(), before);
    EXPECT_EQ(world.objects(simulation).size(), 2u);
}

TEST_P(GpuWorldTest, ACutBeforeAllOfItIsThereUploadsItsPieces)
{
    const auto models = std::make_shared<sim::ModelLibrary>();
    sim::Simulation giant(models, settings(), game::make_scene("giant", models));
    giant.command("size 200000");
    giant.advance(400);
    world.sync(giant);
    ASSERT_TRUE(world.objects(giant).empty());
    giant.push(stroke(giant.time() + 1, 90'000, {0.5, 5.0}, {0.5, -5.0}));
    giant.advance(20);
    ASSERT_GE(giant.bodies().size(), 2u);
    world.sync(giant);
    const auto objects = world.objects(giant);
    ASSERT_EQ(objects.size(), giant.bodies().size());
    for (std::size_t i = 0; i < objects.size(); ++i)
        EXPECT_EQ(objects[i].fragment->triangles, giant.bodies()[i]->object().triangle_count());
    EXPECT_FALSE(world.arriving());
    EXPECT_EQ(bytes_of_cuts() + world.bytes_of_throws(), world.store().bytes_uploaded());
}

TEST_P(GpuWorldTest, SkipsPiecesThatNobodySaw)
{
    game::Autopilot autopilot(1);
    for (int tick = 0; tick < 600; ++tick) {
        simulation.push(autopilot.play(simulation));
        simulation.advance();
    }
    world.sync(simulation);
    EXPECT_EQ(world.objects(simulation).size(), simulation.bodies().size());
    EXPECT_EQ(world.cut_uploads().size(), simulation.cuts().size());
}

/// A ball that is struck and whose pieces wait for the graphics card.
class BreakingTest : public GlTest, public ::testing::WithParamInterface<std::string>
{
protected:
    BreakingTest()
        : models(library_of({"icosphere"}, 2000)), simulation(models, settings(), game::make_scene("shatter", models))
    {
        simulation.command("cells 150");
        simulation.command("strength 0");
        simulation.advance(60);
        world.sync(simulation);
    }

    static sim::Settings settings()
    {
        sim::Settings settings;
        settings.backend = GetParam();
        settings.breaks = sim::Readiness::when_ready;
        return settings;
    }
    void strike()
    {
        const glm::dvec2 place = sim::Camera::seen_on_stage(simulation.bodies().front()->centre());
        simulation.push({simulation.time() + 1, sim::InputKind::press, place, {}});
        simulation.advance();
    }

    std::shared_ptr<sim::ModelLibrary> models;
    sim::Simulation simulation;
    render::LookTable looks;
    app::GpuWorld world{looks};
};

INSTANTIATE_TEST_SUITE_P(BackEnds, BreakingTest, ::testing::Values("halfedge", "baseline/hash"),
                         [](const auto& param) { return param.param == "halfedge" ? "halfedge" : "baseline"; });

TEST_P(BreakingTest, PiecesComeAheadAndTheWholeIsDrawnUntilAllAreThere)
{
    strike();
    ASSERT_TRUE(simulation.is_breaking(simulation.bodies().front()->id()));
    std::uint64_t bytes = world.store().bytes_uploaded();
    while (simulation.breaks().empty() && simulation.now() < 50'000) {
        // A ball that falls off the stage would be forgotten.
        simulation.move_object(simulation.bodies().front()->id(), {});
        simulation.advance();
        if (!simulation.breaks().empty()) break;
        world.sync(simulation);
        EXPECT_EQ(world.objects(simulation).size(), 1u) << "the whole";
        bytes = world.store().bytes_uploaded();
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    ASSERT_EQ(simulation.breaks().size(), 1u);
    ASSERT_GE(simulation.bodies().size(), 150u);
    world.sync(simulation);
    EXPECT_EQ(world.store().bytes_uploaded(), bytes) << "the frame of the break uploads nothing";
    EXPECT_EQ(world.objects(simulation).size(), simulation.bodies().size());
}

TEST_P(BreakingTest, ManySmallPiecesComeInSeveralFrames)
{
    strike();
    while (simulation.waiting_pieces().empty()) std::this_thread::sleep_for(std::chrono::microseconds(200));
    const std::size_t all = simulation.waiting_pieces().size();
    ASSERT_GE(all, 150u);
    const auto ready = [&] {
        std::size_t count = 0;
        for (const sim::WaitingPiece& piece : simulation.waiting_pieces())
            count += view_of(*piece.object).new_vertices_from > 0 ? 1 : 0;
        return count;
    };
    constexpr std::size_t kMostInAFrame = app::GpuWorld::kBytesInAFrame / app::GpuWorld::kBytesOfBuffers;
    std::size_t frames = 0;
    for (std::size_t before = ready(); before < all && frames < 20; ++frames) {
        world.sync(simulation);
        const std::size_t now = ready();
        EXPECT_LE(now - before, kMostInAFrame);
        EXPECT_GT(now, before);
        before = now;
    }
    EXPECT_EQ(ready(), all);
    EXPECT_GE(frames, all / kMostInAFrame);
}

}  // namespace kerf::test
