#include "viewer/app/drawn_world.h"

#include <gtest/gtest.h>

#include "viewer/game/autopilot.h"
#include "viewer/render/gl_test.h"
#include "viewer/sim/back_ends.h"
#include "viewer/sim/stages.h"

namespace kerf::test {

namespace {

class DrawnWorldTest : public GlTest, public ::testing::WithParamInterface<std::string>
{
protected:
    sim::Simulation simulation{shelf_of({"torus", "box", "asteroid"}, 2000), settings()};
    render::LookTable looks;
    app::DrawnWorld world{looks};

    static sim::Settings settings()
    {
        sim::Settings settings;
        settings.backend = GetParam();
        settings.seed = 4;
        return settings;
    }

    /// Plays until so many cuts have happened, and brings every tick onto the card.
    void play_until_cuts(std::size_t count)
    {
        game::Autopilot autopilot(1);
        for (int tick = 0; tick < 2000 && simulation.cuts().size() < count; ++tick) {
            simulation.push(autopilot.play(simulation));
            simulation.advance();
            world.sync(simulation);
        }
        ASSERT_GE(simulation.cuts().size(), count);
    }
};

INSTANTIATE_TEST_SUITE_P(BackEnds, DrawnWorldTest, ::testing::Values("halfedge", "baseline/hash"),
                         [](const auto& param) { return param.param == "halfedge" ? "halfedge" : "baseline"; });

}  // namespace

TEST_P(DrawnWorldTest, UploadsForEachCutWhatTheBackEndSaid)
{
    play_until_cuts(5);
    ASSERT_EQ(world.cut_uploads().size(), simulation.cuts().size());
    for (std::size_t i = 0; i < simulation.cuts().size(); ++i) {
        const sim::CutRecord& cut = simulation.cuts()[i];
        EXPECT_EQ(world.cut_uploads()[i].bytes, cut.statistics.bytes_to_upload) << "cut " << cut.number;
    }
}

TEST_P(DrawnWorldTest, DrawsEveryBodyAndNothingElse)
{
    play_until_cuts(3);
    const auto objects = world.objects(simulation);
    ASSERT_EQ(objects.size(), simulation.bodies().size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        EXPECT_EQ(objects[i].id, simulation.bodies()[i]->id());
        EXPECT_EQ(objects[i].fragment->triangles, simulation.bodies()[i]->object().triangle_count());
    }
}

TEST_P(DrawnWorldTest, HoldsNoMoreBuffersThanThereAreThrowsOrPieces)
{
    play_until_cuts(6);
    for (int tick = 0; tick < 600; ++tick) {
        simulation.advance();
        world.sync(simulation);
    }
    // After five seconds without a swipe all pieces have left; what flies now was thrown whole.
    EXPECT_LE(world.store().buffer_sets(), simulation.bodies().size());
}

TEST_P(DrawnWorldTest, SkipsPiecesThatNobodySaw)
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

}  // namespace kerf::test
