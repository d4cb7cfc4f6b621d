#include "viewer/sim/world.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "common/shapes/shapes.h"
#include "support/public_mesh.h"
#include "viewer/sim/bodies.h"
#include "viewer/sim/camera.h"

namespace kerf::sim {
namespace {

Mesh unit_box()
{
    return test::mesh_of(core::shapes::box({1, 1, 1}, {1, 1, 1}));
}

std::unique_ptr<Body> sibling(ObjectId id, const glm::dvec3& centre, std::uint64_t cut, Tick until)
{
    Identity identity;
    identity.id = id;
    if (cut > 0) identity.recent_cuts.push_back({cut, until});
    Object object = test::object_of(unit_box());
    MeshPose pose;
    pose.translation = centre;
    const Solid solid = solid_of(object.mass_properties(), object.bounds(), 1.0);
    return std::make_unique<Body>(identity, std::move(object), solid, pose, Motion{}, ProxyKind::full_hull);
}

TEST(World, FallsByGravityInTicks)
{
    World world(9.81);
    Body& body = world.add(test::body_of(unit_box(), 1, {0, 0, 0}, {{0, 3, 0}, {}}));
    for (int i = 0; i < kTicksPerSecond; ++i) world.step();
    EXPECT_EQ(world.now(), kTicksPerSecond);
    EXPECT_NEAR(body.motion().velocity.y, 3.0 - 9.81, 1e-3);
    // Symplectic Euler falls half a tick ahead of the parabola.
    EXPECT_NEAR(body.centre().y, 3.0 - 9.81 / 2 * (1 + kTickSeconds), 1e-3);
}

TEST(World, BodiesAreInTheOrderOfTheirIdsWhateverOrderTheyCameIn)
{
    World world;
    for (const ObjectId id : {3u, 1u, 2u}) world.add(test::body_of(unit_box(), id, {3.0 * double(id), 0, 0}));
    ASSERT_EQ(world.bodies().size(), 3u);
    for (ObjectId id = 1; id <= 3; ++id) EXPECT_EQ(world.bodies()[std::size_t(id - 1)]->id(), id);
    EXPECT_EQ(world.find(2)->id(), 2u);
    EXPECT_EQ(world.find(9), nullptr);
    EXPECT_EQ(world.remove(9), nullptr);
    EXPECT_EQ(world.remove(2)->id(), 2u);
    EXPECT_EQ(world.find(2), nullptr);
}

TEST(World, SiblingsPassThroughEachOtherForTheirFirst100Milliseconds)
{
    World world(0.0);
    world.add(sibling(1, {0, 0, 0}, 5, kSiblingTicks));
    world.add(sibling(2, {0.9, 0, 0}, 5, kSiblingTicks));
    for (Tick i = 1; i < kSiblingTicks; ++i) {
        world.step();
        EXPECT_EQ(world.contacts(), 0u) << "tick " << i;
    }
    world.step();
    EXPECT_EQ(world.now() * 1000 / kTicksPerSecond, 100);
    EXPECT_EQ(world.contacts(), 1u);
}

TEST(World, StrangersCollideAtOnce)
{
    for (const std::uint64_t other_cut : {0u, 6u}) {
        World world(0.0);
        world.add(sibling(1, {0, 0, 0}, 5, kSiblingTicks));
        world.add(sibling(2, {0.9, 0, 0}, other_cut, kSiblingTicks));
        world.step();
        EXPECT_EQ(world.contacts(), 1u);
    }
}

TEST(World, WhatEntersTouchesNothingUntilAllOfItIsOnTheStage)
{
    World world(0.0);
    Body& entering = world.add(test::body_of(unit_box(), 1, {0, -kStageHalfHeight - 1.5, 0}, {{0, 6, 0}, {}}));
    entering.set_entering(true);
    world.add(test::body_of(unit_box(), 2, {0, -kStageHalfHeight, 0}));  // in the way, half out of sight
    world.add(test::body_of(unit_box(), 3, {0, 0, 0}));                  // in the way, on the stage
    while (entering.is_entering()) {
        ASSERT_LT(world.now(), kTicksPerSecond);
        world.step();
        EXPECT_EQ(world.contacts(), 0u) << "tick " << world.now();
        EXPECT_EQ(entering.motion().velocity, glm::dvec3(0, 6, 0));
        EXPECT_EQ(entering.is_entering(), entering.centre().y - entering.radius() < -kStageHalfHeight);
    }
    for (int i = 0; i < kTicksPerSecond; ++i) world.step();
    EXPECT_LT(entering.motion().velocity.y, 6.0) << "it met the one on the stage";
    EXPECT_EQ(world.find(2)->motion().velocity, glm::dvec3(0.0));
}

TEST(World, OverlapsAreResolvedWithoutAnExplosion)
{
    World world(0.0);
    world.add(sibling(1, {0, 0, 0}, 0, 0));
    world.add(sibling(2, {0.5, 0, 0}, 0, 0));
    for (int i = 0; i < 240; ++i) world.step();
    for (const auto& body : world.bodies()) EXPECT_LE(glm::length(body->motion().velocity), 0.1);
    EXPECT_GE(world.bodies()[1]->centre().x - world.bodies()[0]->centre().x, 0.9);
}

TEST(World, ACollisionKeepsMomentum)
{
    World world(0.0);
    world.add(test::body_of(unit_box(), 1, {-2, 0, 0}, {{4, 0.3, 0}, {0, 1, 0}}));
    world.add(test::body_of(test::shape("asteroid"), 2, {2, 0.4, 0}, {{-3, 0, 0.1}, {1, 0, 0}}));
    const auto total = [&] {
        glm::dvec3 sum(0.0);
        for (const auto& body : world.bodies()) sum += body->momentum();
        return sum;
    };
    const glm::dvec3 before = total();
    bool touched = false;
    for (int i = 0; i < 120; ++i) {
        world.step();
        touched = touched || world.contacts() > 0;
    }
    EXPECT_TRUE(touched);
    EXPECT_NEAR(glm::distance(total(), before), 0.0, 1e-4 * 600 * 8);
}

TEST(World, FreesWhatLeftTheStageForGood)
{
    World world;
    const struct
    {
        glm::dvec3 centre, velocity;
        bool gone;
    } cases[] = {
        {{0, 0, 0}, {0, -5, 0}, false},          {{0, -6, 0}, {0, 9, 0}, false},  // below, but coming up
        {{0, -6, 0}, {0, -1, 0}, true},                                           // below and falling
        {{0, 9, 0}, {0, 1, 0}, false},                                            // above: comes back
        {{30, 0, 0}, {0, 9, 0}, true},                                            // far to the side
        {{0, 0, 20}, {0, 9, 0}, true},                                            // behind the eye
        {{0, std::nan(""), 0}, {0, 0, 0}, true},                                  // lost
    };
    ObjectId id = 0;
    for (const auto& c : cases) world.add(test::body_of(unit_box(), ++id, c.centre, {c.velocity, {}}));
    std::vector<ObjectId> expected, gone;
    for (std::size_t i = 0; i < std::size(cases); ++i)
        if (cases[i].gone) expected.push_back(i + 1);
    for (const auto& body : world.remove_gone()) gone.push_back(body->id());
    EXPECT_EQ(gone, expected);
    EXPECT_EQ(world.bodies().size(), std::size(cases) - expected.size());
}

}  // namespace
}  // namespace kerf::sim
