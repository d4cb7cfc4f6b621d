// Objects of a simulation that are struck: Simulation::strike() and what comes of it.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <glm/geometric.hpp>
#include <thread>

#include "viewer/sim/back_ends.h"
#include "viewer/sim/simulation.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

/// Nothing happens but what the test does; the blade smashes if the test says so.
class QuietScene : public Scene
{
public:
    std::string_view name() const override { return "quiet"; }
    double gravity() const override { return 0.0; }
    void tick(Simulation&) override {}
    std::optional<Breaking> smashes(const Body&) const override { return smash; }
    std::optional<Breaking> crashes(const Body&, double) const override { return crash; }
    void on_broken(Simulation&, const BreakRecord&) override { ++broken; }

    std::optional<Breaking> smash, crash;
    int broken = 0;
};

/// One shape; "open ball" is a ball that lacks some triangles.
std::shared_ptr<ModelLibrary> library_with(const std::string& shape)
{
    if (shape != "open ball") return test::library_of({shape}, 1280);
    const Mesh ball = test::shape("icosphere", 1280);
    MeshInput open = test::input_of(ball);
    open.triangle_count -= 80;
    auto models = std::make_shared<ModelLibrary>();
    models->add("open ball", test::value_of(Mesh::make(open)));
    return models;
}

struct Stage
{
    explicit Stage(Readiness breaks = Readiness::at_once, const std::string& backend = backend_names().front(),
                   bool record = false, const std::string& shape = "icosphere")
        : simulation(library_with(shape), settings_of(breaks, backend, record), make_scene())
    {
        body = simulation.place_object(0, 1.0, {0, 0, 0}, glm::dmat3(1.0), {{0.3, 0.1, 0.0}, {0.0, 0.5, 0.2}});
    }

    static Settings settings_of(Readiness breaks, const std::string& backend, bool record)
    {
        Settings settings;
        settings.breaks = breaks;
        settings.backend = backend;
        settings.record = record;
        return settings;
    }
    std::unique_ptr<Scene> make_scene()
    {
        auto made = std::make_unique<QuietScene>();
        scene = made.get();
        return made;
    }
    void strike(double impulse, double strength)
    {
        Breaking how;
        how.cells = 30;
        how.strength = strength;
        simulation.strike(body->id(), {{0, 0, 9}, {0, 0, -impulse}, {0, 0, -1}}, how);
    }

    QuietScene* scene = nullptr;
    Simulation simulation;
    const Body* body = nullptr;
};

glm::dvec3 momentum_of(const Simulation& simulation)
{
    glm::dvec3 sum(0.0);
    for (const auto& body : simulation.bodies()) sum += body->momentum();
    return sum;
}

double mass_of(const Simulation& simulation)
{
    double sum = 0.0;
    for (const auto& body : simulation.bodies()) sum += body->mass();
    return sum;
}

/// What a renderer does with pieces that wait.
void upload_waiting(const Simulation& simulation)
{
    for (const WaitingPiece& piece : simulation.waiting_pieces()) {
        DrawView view;
        ASSERT_EQ(piece.object->draw(view), Status::done);
        piece.object->mark_uploaded(view);
    }
}

class StrikeTest : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(Strike, StrikeTest, testing::ValuesIn(backend_names()), test::back_end_test_name);

}  // namespace

TEST_P(StrikeTest, WithoutBondsItFliesApart)
{
    Stage stage(Readiness::at_once, GetParam());
    const double mass = stage.body->mass();
    const glm::dvec3 before = momentum_of(stage.simulation);
    stage.strike(500.0, 0.0);
    EXPECT_TRUE(stage.simulation.is_breaking(1)) << "in this tick it is there as it was";
    EXPECT_EQ(stage.simulation.bodies().size(), 1u);
    stage.simulation.advance();
    ASSERT_EQ(stage.simulation.breaks().size(), 1u);
    const BreakRecord& broken = stage.simulation.breaks().front();
    EXPECT_EQ(broken.status, Status::done);
    EXPECT_EQ(broken.backend, GetParam());
    EXPECT_EQ(broken.dropped, 0u);
    EXPECT_GE(broken.pieces.size(), 30u);
    EXPECT_EQ(stage.simulation.bodies().size(), broken.pieces.size());
    EXPECT_TRUE(stage.simulation.world().clusters().empty());
    EXPECT_NEAR(mass_of(stage.simulation), mass, 1e-6 * mass);
    const glm::dvec3 gained = momentum_of(stage.simulation) - before;
    EXPECT_LT(glm::distance(gained, glm::dvec3(0, 0, -500)), 0.5) << "N s, floats of a thousand kilograms";
    EXPECT_EQ(stage.scene->broken, 1);
    EXPECT_NEAR(broken.place.z, 1.0, 0.05) << "where the ray meets the ball";
}

TEST_P(StrikeTest, StrongBondsHoldUntilABlowThatIsStrongEnough)
{
    Stage stage(Readiness::at_once, GetParam());
    const double mass = stage.body->mass();
    stage.strike(10.0, 500.0);
    stage.simulation.advance();
    ASSERT_EQ(stage.simulation.world().clusters().size(), 1u) << "it cracked and holds";
    const std::size_t pieces = stage.simulation.bodies().size();
    EXPECT_EQ(stage.simulation.world().clusters().front()->members().size(), pieces);

    // Ever harder: ever less hangs together, in the end nothing.
    std::size_t held = pieces;
    for (const double impulse : {200.0, 1000.0, 5000.0, 1e5}) {
        if (stage.simulation.world().clusters().empty()) break;
        const Body& member = *stage.simulation.world().clusters().front()->members().front();
        stage.simulation.strike(member.id(), {member.centre(), {0, 0, -impulse}}, {});
        stage.simulation.advance();
        std::size_t left = 0;
        for (const auto& cluster : stage.simulation.world().clusters()) left += cluster->members().size();
        EXPECT_LE(left, held);
        held = left;
    }
    EXPECT_LT(held, pieces);
    EXPECT_EQ(stage.simulation.bodies().size(), pieces) << "nothing is lost";
    EXPECT_NEAR(mass_of(stage.simulation), mass, 1e-6 * mass);
    EXPECT_EQ(stage.simulation.breaks().size(), 1u) << "it was taken apart once";
}

TEST_P(StrikeTest, TheSameBlowGivesTheSameState)
{
    const auto hash = [&] {
        Stage stage(Readiness::at_once, GetParam());
        stage.strike(800.0, 300.0);
        stage.simulation.advance(100);
        return stage.simulation.state_hash();
    };
    EXPECT_EQ(hash(), hash());
}

TEST(Strike, BackEndsBreakAlike)
{
    Stage one(Readiness::at_once, backend_names().front()), other(Readiness::at_once, "baseline/remap");
    for (Stage* stage : {&one, &other}) {
        stage->strike(800.0, 300.0);
        stage->simulation.advance(2);
    }
    ASSERT_EQ(one.simulation.bodies().size(), other.simulation.bodies().size());
    for (std::size_t i = 0; i < one.simulation.bodies().size(); ++i) {
        EXPECT_NEAR(one.simulation.bodies()[i]->mass(), other.simulation.bodies()[i]->mass(), 1e-3);
        EXPECT_LT(glm::distance(one.simulation.bodies()[i]->centre(), other.simulation.bodies()[i]->centre()), 1e-3);
    }
    EXPECT_EQ(one.simulation.world().clusters().size(), other.simulation.world().clusters().size());
}

TEST(Strike, ARayThatGoesPastBreaksNothing)
{
    Stage stage(Readiness::at_once, backend_names().front(), false, "torus");
    Breaking how;
    // Through the hole: the hull is hit, the ring is not.
    stage.simulation.strike(1, {{0, 0, 9}, {0, 0, -500}, {0, 0, -1}}, how);
    stage.simulation.advance();
    ASSERT_EQ(stage.simulation.breaks().size(), 1u);
    EXPECT_EQ(stage.simulation.breaks().front().status, Status::missed);
    EXPECT_EQ(stage.simulation.bodies().size(), 1u);
    EXPECT_FALSE(stage.simulation.bodies().front()->object().is_empty());
    EXPECT_EQ(stage.simulation.take_message(), "");
}

TEST(Strike, WhatIsOpenStaysAndTheReasonIsSaid)
{
    Stage stage(Readiness::at_once, backend_names().front(), false, "open ball");
    stage.simulation.strike(1, {stage.body->centre(), {0, 0, -500}}, {});
    stage.simulation.advance();
    EXPECT_EQ(stage.simulation.bodies().size(), 1u);
    EXPECT_FALSE(stage.simulation.bodies().front()->object().is_empty());
    EXPECT_NE(stage.simulation.take_message().find("open"), std::string::npos);
}

TEST(Strike, ABladeThatSmashesBreaksWhatItGoesThrough)
{
    Stage stage;
    stage.scene->smash = Breaking{};
    stage.simulation.push(test::stroke(20'000, 60'000, {-2.0, 0.0}, {2.0, 0.3}));
    stage.simulation.advance(30);
    EXPECT_TRUE(stage.simulation.cuts().empty());
    ASSERT_EQ(stage.simulation.breaks().size(), 1u) << "once a swipe, and not its pieces again";
    EXPECT_EQ(stage.simulation.breaks().front().status, Status::done);
}

TEST(Strike, ABladeThatPassesBesideSmashesNothing)
{
    Stage stage(Readiness::at_once, backend_names().front(), false, "torus");
    stage.scene->smash = Breaking{};
    stage.simulation.push(test::stroke(20'000, 60'000, {-3.0, 3.5}, {3.0, 3.5}));
    stage.simulation.advance(30);
    EXPECT_TRUE(stage.simulation.breaks().empty());
}

TEST(Strike, WhatIsBeingBrokenIsNeitherCutNorStruckAgain)
{
    Stage stage(Readiness::on_command);
    stage.strike(500.0, 0.0);
    stage.strike(500.0, 0.0);
    stage.simulation.push(test::stroke(20'000, 60'000, {-2.0, 0.0}, {2.0, 0.3}));
    stage.simulation.advance(30);
    EXPECT_TRUE(stage.simulation.cuts().empty());
    EXPECT_EQ(stage.simulation.bodies().size(), 1u);
    stage.simulation.command("break 1");
    stage.simulation.advance(1);
    EXPECT_EQ(stage.simulation.breaks().size(), 1u);
    EXPECT_GT(stage.simulation.bodies().size(), 1u);
}

TEST(Strike, WhatLeavesMeanwhileIsForgotten)
{
    Stage stage(Readiness::on_command);
    stage.strike(500.0, 0.0);
    stage.simulation.move_object(1, {{0, -20, 0}, {}});
    stage.simulation.advance(300);
    EXPECT_TRUE(stage.simulation.bodies().empty());
    EXPECT_FALSE(stage.simulation.is_breaking(1));
    stage.simulation.command("break 1");
    stage.simulation.advance(2);
    EXPECT_TRUE(stage.simulation.breaks().empty());
}

TEST(Strike, ReadyPiecesWaitForTheGraphicsCardAndARecordingRepeatsTheRun)
{
    Stage played(Readiness::when_ready, backend_names().front(), true);
    played.simulation.advance(5);
    played.simulation.command("gesture segment");  // something to record before
    played.strike(800.0, 300.0);
    const Tick struck = played.simulation.now();
    while (played.simulation.waiting_pieces().empty() && played.simulation.now() < 100'000) {
        played.simulation.advance();
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    played.simulation.advance(10);
    EXPECT_EQ(played.simulation.bodies().size(), 1u) << "nothing is on the graphics card";
    upload_waiting(played.simulation);
    played.simulation.advance(3);
    ASSERT_GT(played.simulation.bodies().size(), 1u);
    played.simulation.advance(20);

    Stage repeated(Readiness::on_command, backend_names().front(), true);
    repeated.simulation.push(played.simulation.recording().events);
    repeated.simulation.advance(5);
    while (repeated.simulation.now() < struck) repeated.simulation.advance();
    repeated.strike(800.0, 300.0);
    repeated.simulation.advance(played.simulation.now() - repeated.simulation.now());
    EXPECT_EQ(repeated.simulation.state_hash(), played.simulation.state_hash());
}

TEST(Strike, ACollisionBreaksWhatTheSceneSays)
{
    Stage stage;
    Breaking how;
    how.strength = 1e9;
    stage.scene->crash = how;
    stage.simulation.place_object(0, 0.5, {-3.0, 0.0, 0.0}, glm::dmat3(1.0), {{8.0, 0.0, 0.0}, {}});
    stage.simulation.advance(60);
    ASSERT_EQ(stage.simulation.breaks().size(), 2u) << "each of the two";
    EXPECT_EQ(stage.simulation.world().clusters().size(), 2u) << "cracked, and held by their bonds";
}

TEST(Strike, AFarPieceCanBeCutOutOfACluster)
{
    Stage stage;
    stage.strike(1.0, 1e6);
    stage.simulation.advance();
    const std::size_t pieces = stage.simulation.bodies().size();
    ASSERT_EQ(stage.simulation.world().clusters().size(), 1u);
    stage.simulation.push(test::stroke(stage.simulation.time() + 20'000, 60'000, {-2.0, 0.0}, {2.0, 0.3}));
    stage.simulation.advance(40);
    EXPECT_FALSE(stage.simulation.cuts().empty());
    EXPECT_GT(stage.simulation.bodies().size(), pieces);
}

}  // namespace kerf::sim
