#include "viewer/sim/body.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "viewer/sim/bodies.h"
#include "viewer/sim/world.h"

namespace kerf::sim {
namespace {

TEST(Body, StandsWhereItWasPut)
{
    Identity identity;
    identity.id = 1;
    MeshPose pose;
    pose.scale = identity.origin.scale = 0.3;
    pose.rotation = glm::mat3_cast(glm::normalize(glm::dquat(0.3, -0.5, 0.7, 0.1)));
    pose.translation = {1, 2, -3};
    Object object = test::object_of(test::shape("l_step"));
    const Solid solid = solid_of(object.mass_properties(), object.bounds(), pose.scale);
    const Body body(identity, std::move(object), solid, pose, {{1, 2, 3}, {4, 5, 6}}, ProxyKind::full_hull);
    for (const glm::dvec3 p : {glm::dvec3{0, 0, 0}, {1, 1, 1}, {-3, 2, 5}}) {
        EXPECT_NEAR(glm::distance(body.pose().to_world(p), pose.to_world(p)), 0.0, 2e-6);
        const glm::dvec4 drawn = body.model_matrix() * glm::dvec4(p, 1);
        EXPECT_NEAR(glm::distance(glm::dvec3(drawn), pose.to_world(p)), 0.0, 2e-6);
    }
    EXPECT_NEAR(glm::distance(body.centre(), pose.to_world(solid.centre)), 0.0, 1e-6);
    EXPECT_EQ(body.motion().velocity, glm::dvec3(1, 2, 3));
    EXPECT_EQ(body.motion().spin, glm::dvec3(4, 5, 6));
}

TEST(Body, IsDrawnBetweenTheLastTickAndThisOne)
{
    World world(0.0);
    Body& body = world.add(test::body_of(test::shape("box"), 1, {0, 0, 0}, {{1.2, 0, 0}, {0, 0, 1.2}}));
    world.step();
    world.step();
    EXPECT_NEAR(body.pose_at(0.0).translation.x, 0.01, 1e-6);
    EXPECT_NEAR(body.pose_at(0.5).translation.x, 0.015, 1e-6);
    EXPECT_NEAR(body.pose_at(1.0).translation.x, 0.02, 1e-6);
    EXPECT_NEAR(body.pose_at(0.5).rotation[0].y, std::sin(0.015), 1e-5);
    EXPECT_EQ(body.pose_at(1.0).matrix(), body.pose().matrix());
}

TEST(Body, AFreeBodyKeepsItsMomentumAndSpinsAboutItsCentreOfMass)
{
    World world(0.0);
    const glm::dvec3 spin(0.4, 1.1, -0.7);
    Body& body = world.add(test::body_of(test::shape("two_legs"), 1, {0, 0, 0}, {{0.5, 0.2, 0}, spin}));
    const glm::dvec3 start = body.centre(), momentum = body.momentum();
    const glm::dvec3 angular = body.angular_momentum(start);
    for (int i = 0; i < 120; ++i) world.step();
    EXPECT_NEAR(glm::distance(body.centre(), start + glm::dvec3(0.5, 0.2, 0)), 0.0, 1e-4);
    EXPECT_NEAR(glm::distance(body.momentum(), momentum) / glm::length(momentum), 0.0, 1e-6);
    // Bullet's implicit gyroscopic step is of first order: 1 % in a second.
    EXPECT_NEAR(glm::distance(body.angular_momentum(start), angular) / glm::length(angular), 0.0, 0.02);
}

}  // namespace
}  // namespace kerf::sim
