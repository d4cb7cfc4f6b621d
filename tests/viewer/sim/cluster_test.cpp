#include "viewer/sim/cluster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "viewer/sim/back_ends.h"
#include "viewer/sim/bodies.h"
#include "viewer/sim/breaking/breaker.h"
#include "viewer/sim/world.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

/// A broken ball in a world without gravity: its pieces in one pose, each with a body.
class ClusterTest : public testing::Test
{
protected:
    ClusterTest()
    {
        auto shared = std::make_shared<BreakJob>();
        shared->object = test::object_of(test::shape("icosphere", 1280), backend_names().front());
        shared->options.cells = 30;
        Breaker breaker;
        breaker.start(shared);
        shared->wait();
        pose.translation = {0.5, 0.25, 0.0};
        for (BrokenPiece& piece : shared->pieces) {
            Identity identity;
            identity.id = ids.empty() ? 1 : ids.back() + 1;
            const glm::dvec3 arm = pose.to_world(piece.solid.centre) - pose.translation;
            const Motion part{motion.velocity + glm::cross(motion.spin, arm), motion.spin};
            bodies.push_back(&world.add(std::make_unique<Body>(identity, std::move(piece.object), piece.solid, pose,
                                                               part, std::move(piece.proxy))));
            ids.push_back(identity.id);
        }
        for (const FractureBond& bond : shared->bonds) bonds.push_back({ids[bond.first], ids[bond.second], bond.area});
    }

    glm::dvec3 momentum() const
    {
        glm::dvec3 sum(0.0);
        for (const Body* const body : bodies) sum += body->momentum();
        return sum;
    }
    glm::dvec3 angular_momentum() const
    {
        glm::dvec3 sum(0.0);
        for (const Body* const body : bodies) sum += body->angular_momentum({0, 0, 0});
        return sum;
    }
    double mass() const
    {
        double sum = 0.0;
        for (const Body* const body : bodies) sum += body->mass();
        return sum;
    }

    World world{0.0};
    MeshPose pose;
    Motion motion{{0.2, -0.1, 0.3}, {0.4, 1.0, -0.3}};
    std::vector<Body*> bodies;
    std::vector<ObjectId> ids;
    std::vector<Bond> bonds;
};

}  // namespace

TEST_F(ClusterTest, MovesAsItsMembersDid)
{
    const glm::dvec3 before = momentum(), spin_before = angular_momentum();
    ASSERT_EQ(world.bind(bodies, bonds).size(), 1u);
    ASSERT_EQ(world.clusters().size(), 1u);
    const Cluster& cluster = *world.clusters().front();
    EXPECT_EQ(cluster.members().size(), bodies.size());
    EXPECT_NEAR(cluster.mass(), mass(), 1e-9 * mass());
    // Bullet keeps velocities as floats.
    EXPECT_LT(glm::distance(momentum(), before), 1e-5 * glm::length(before));
    EXPECT_LT(glm::distance(angular_momentum(), spin_before), 1e-4 * glm::length(spin_before));
    EXPECT_LT(glm::distance(cluster.mass() * cluster.motion().velocity, before), 1e-5 * glm::length(before));
}

TEST_F(ClusterTest, AllMembersHaveOnePoseBitForBit)
{
    world.bind(bodies, bonds);
    for (int i = 0; i < 50; ++i) world.step();
    for (const double fraction : {0.0, 0.3, 1.0}) {
        const glm::dmat4 first = bodies.front()->model_matrix(fraction);
        for (const Body* const body : bodies) EXPECT_EQ(body->model_matrix(fraction), first);
    }
}

TEST_F(ClusterTest, StaysTheRigidBodyThatItIsWhileItTurns)
{
    world.bind(bodies, bonds);
    const double apart = glm::distance(bodies.front()->centre(), bodies.back()->centre());
    const glm::dvec3 before = momentum();
    for (int i = 0; i < 240; ++i) world.step();
    EXPECT_NEAR(glm::distance(bodies.front()->centre(), bodies.back()->centre()), apart, 1e-4);
    EXPECT_LT(glm::distance(momentum(), before), 1e-4 * glm::length(before));
    const glm::dvec3 placed = bodies.front()->pose().to_world(bodies.front()->solid().centre);
    EXPECT_LT(glm::distance(placed, bodies.front()->centre()), 1e-5);
}

TEST_F(ClusterTest, FallsIntoWhatBondsStillHold)
{
    world.bind(bodies, bonds);
    const glm::dvec3 before = momentum(), spin_before = angular_momentum();
    // Nothing holds the first five.
    std::vector<Bond> left = bonds;
    std::erase_if(left, [&](const Bond& bond) { return bond.first <= 5 || bond.second <= 5; });
    const auto parts = world.part(*world.clusters().front(), left);
    std::size_t members = 0, single = 0;
    for (const auto& part : parts) {
        members += part.size();
        single += part.size() == 1 ? 1 : 0;
        for (const Body* const body : part) EXPECT_EQ(body->cluster() == nullptr, part.size() == 1);
    }
    EXPECT_EQ(members, bodies.size());
    EXPECT_GE(single, 5u);
    EXPECT_EQ(world.clusters().size(), parts.size() - single);
    EXPECT_LT(glm::distance(momentum(), before), 1e-5 * glm::length(before));
    EXPECT_LT(glm::distance(angular_momentum(), spin_before), 1e-4 * glm::length(spin_before));
}

TEST_F(ClusterTest, AMemberThatIsTakenOutLeavesTheRestAsItWas)
{
    world.bind(bodies, bonds);
    const std::unique_ptr<Body> gone = world.remove(ids[3]);
    ASSERT_NE(gone, nullptr);
    EXPECT_EQ(gone->cluster(), nullptr);
    std::size_t held = 0;
    for (const auto& cluster : world.clusters()) held += cluster->members().size();
    EXPECT_GE(held, bodies.size() - 4) << "hardly any piece hangs on this one alone";
    for (int i = 0; i < 10; ++i) world.step();
}

TEST_F(ClusterTest, LeavesTheStageAsAWhole)
{
    world.bind(bodies, bonds);
    Motion away = motion;
    away.velocity = {0.0, -8.0, 0.0};
    world.clusters().front()->set_motion(away);
    std::size_t gone = 0;
    for (int i = 0; i < 600 && gone == 0; ++i) {
        world.step();
        gone = world.remove_gone().size();
        EXPECT_TRUE(gone == 0 || gone == bodies.size());
    }
    EXPECT_EQ(gone, bodies.size());
    EXPECT_TRUE(world.bodies().empty());
    EXPECT_TRUE(world.clusters().empty());
}

TEST_F(ClusterTest, ARayMeetsTheMemberThatLiesInItsWay)
{
    world.bind(bodies, bonds);
    for (const Body* const body : bodies) {
        const glm::dvec3 outwards = glm::normalize(body->centre() - pose.translation);
        const glm::dvec3 from = pose.translation + 5.0 * outwards;
        const std::optional<RayHit> hit = world.first_on_ray(from, pose.translation);
        ASSERT_TRUE(hit);
        // Whoever it is, it lies on the ray, and no farther out than the ball.
        EXPECT_NE(world.find(hit->object), nullptr);
        EXPECT_NEAR(glm::distance(hit->place, pose.translation), 1.0, 0.1);
        EXPECT_LT(glm::distance(hit->place, world.find(hit->object)->centre()),
                  world.find(hit->object)->radius() + 0.05);
    }
    EXPECT_FALSE(world.first_on_ray({9, 9, 9}, {9, 0, 9}));
}

TEST_F(ClusterTest, ImpactsTellWhatWasDealt)
{
    world.bind(bodies, bonds);
    const double ball = mass();
    world.add(test::body_of(test::shape("icosphere", 320), 1000, {-3.0, 0.25, 0.0}, {{6.0, 0.0, 0.0}, {}}));
    std::vector<Impact> impacts;
    for (int i = 0; i < 120 && impacts.empty(); ++i) {
        world.step();
        impacts = world.impacts(1.0);
    }
    ASSERT_EQ(impacts.size(), 2u);
    EXPECT_EQ(impacts.front().other, impacts.back().object);
    EXPECT_LT(glm::length(impacts.front().impulse + impacts.back().impulse), 1e-6);
    // What makes it turn back is the change of its momentum: more than half of it, less than all of it twice.
    const double dealt = glm::length(impacts.front().impulse);
    EXPECT_GT(dealt, 0.5 * 6.0 * 0.5 * ball);
    EXPECT_LT(dealt, 2.0 * 6.0 * ball);
}

}  // namespace kerf::sim
