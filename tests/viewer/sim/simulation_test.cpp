#include "viewer/sim/simulation.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "viewer/sim/back_ends.h"
#include "viewer/sim/stages.h"

namespace kerf::sim {
namespace {

using test::report_shelf;
using test::shelf_of;
using test::stroke;

Settings with_backend(const std::string& backend, std::uint64_t seed = 1)
{
    Settings settings;
    settings.backend = backend;
    settings.seed = seed;
    settings.hash_surfaces = true;
    return settings;
}

// A stroke through the middle of the first object of a run, when it is near its apex.
std::vector<InputEvent> stroke_through_first(Simulation& probe, double angle, Tick at = 90)
{
    probe.advance(at);
    const glm::dvec3 c = probe.bodies().front()->centre();
    // Where the eye sees the centre on the stage.
    const double t = kEyeDistance / (kEyeDistance - c.z);
    const glm::dvec2 middle = glm::dvec2(c) * t, along = 2.0 * glm::dvec2(std::cos(angle), std::sin(angle));
    return stroke(time_of(at) - 40'000, 80'000, middle - along, middle + along);
}

class OnEachBackEnd : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(Simulation, OnEachBackEnd, testing::ValuesIn(backend_names()), [](const auto& backend) {
    std::string name = backend.param;
    for (char& c : name)
        if (c == '/') c = '_';
    return name;
});

TEST_P(OnEachBackEnd, CutsWhatTheSwipeCrosses)
{
    const auto models = report_shelf();
    Simulation probe(models, with_backend(GetParam()));
    Simulation run(models, with_backend(GetParam()));
    run.push(stroke_through_first(probe, 0.3));
    run.advance(110);
    ASSERT_EQ(run.cuts().size(), 1u);
    const CutRecord& cut = run.cuts().front();
    EXPECT_EQ(cut.status, Status::cut);
    EXPECT_EQ(cut.backend, GetParam());
    EXPECT_EQ(cut.object, 1u);
    EXPECT_GE(cut.pieces.size(), 2u);
    EXPECT_GT(cut.statistics.crossing_triangles, 0u);
    EXPECT_EQ(run.bodies().size(), cut.pieces.size());
}

TEST_P(OnEachBackEnd, RepeatsARunBitForBit)
{
    const auto models = report_shelf();
    const auto run = [&] {
        Simulation probe(models, with_backend(GetParam(), 7));
        Simulation simulation(models, with_backend(GetParam(), 7));
        simulation.push(stroke_through_first(probe, 1.1));
        simulation.advance(600);
        return simulation.state_hash();
    };
    EXPECT_EQ(run(), run());
}

TEST(Simulation, RefusesWhatItDoesNotKnowWithASentence)
{
    Settings settings;
    settings.scene = "circus";
    EXPECT_THROW(Simulation(report_shelf(), settings), std::invalid_argument);
    EXPECT_THROW(Simulation(report_shelf(), with_backend("axe")), std::invalid_argument);
    EXPECT_THROW(Simulation(std::make_shared<ModelShelf>(), Settings{}), std::invalid_argument);
}

}  // namespace
}  // namespace kerf::sim
