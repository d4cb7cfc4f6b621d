#include "viewer/sim/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "common/shapes/shapes.h"
#include "support/public_mesh.h"
#include "viewer/sim/kerf_glm.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

MassProperties mass_of(const Mesh& mesh)
{
    return test::object_of(mesh).mass_properties();
}

Solid solid_of_mesh(const Mesh& mesh, double scale = 1.0)
{
    return solid_of(mass_of(mesh), mesh.bounds(), scale);
}

Mesh brick_of(const glm::vec3& size)
{
    return test::mesh_of(core::shapes::box(size, {1, 1, 1}));
}

double largest_difference(const glm::dmat3& a, const glm::dmat3& b)
{
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) largest = std::max(largest, std::abs(a[c][r] - b[c][r]));
    return largest;
}

TEST(Solid, ABrickHasTheTextbooksMassAndInertia)
{
    const Solid solid = solid_of_mesh(brick_of({1, 2, 3}));
    EXPECT_TRUE(solid.from_geometry);
    EXPECT_NEAR(solid.mass, 6 * kDensity, 1e-6);
    EXPECT_NEAR(solid.moments.x, solid.mass / 12 * (1 + 4), 1e-6);
    EXPECT_NEAR(solid.moments.y, solid.mass / 12 * (1 + 9), 1e-6);
    EXPECT_NEAR(solid.moments.z, solid.mass / 12 * (4 + 9), 1e-6);
}

TEST(Solid, MassGrowsWithTheCubeOfTheScaleAndInertiaWithTheFifthPower)
{
    const Mesh mesh = test::shape("asteroid");
    const Solid one = solid_of_mesh(mesh), two = solid_of_mesh(mesh, 2.0);
    EXPECT_NEAR(two.mass / one.mass, 8.0, 1e-12);
    EXPECT_NEAR(two.moments.x / one.moments.x, 32.0, 1e-9);
    EXPECT_EQ(two.centre, one.centre);
}

TEST(Solid, PrincipalAxesAreAFrameInWhichTheInertiaIsDiagonal)
{
    for (const char* name : {"asteroid", "l_step", "torus", "comb", "two_legs"}) {
        const Mesh mesh = test::shape(name);
        const Solid solid = solid_of_mesh(mesh);
        EXPECT_NEAR(glm::determinant(solid.axes), 1.0, 1e-9) << name;
        EXPECT_LE(largest_difference(solid.axes * glm::transpose(solid.axes), glm::dmat3(1.0)), 1e-9) << name;
        EXPECT_LE(solid.moments.x, solid.moments.y) << name;
        EXPECT_LE(solid.moments.y, solid.moments.z) << name;
        const glm::dmat3 expected = to_glm(mass_of(mesh).inertia) * kDensity;
        EXPECT_LE(largest_difference(solid.inertia(), expected), 1e-9 * solid.moments.z) << name;
    }
}

TEST(Solid, WhatBoundsNoVolumeGetsABoxInstead)
{
    const Mesh cube = brick_of({1, 1, 1});
    MassProperties inside_out = mass_of(cube);  // as if all its triangles were turned over
    inside_out.volume = -inside_out.volume;
    for (auto& column : inside_out.inertia.m)
        for (double& number : column) number = -number;
    const Box sheet{{-1, 2, 0}, {1, 3, 0}}, nothing = Object().bounds();
    ASSERT_TRUE(nothing.is_empty());
    MassProperties far_off;
    far_off.volume = 1.0;
    far_off.centre = {9, 9, 9};
    for (const Solid& solid : {solid_of(inside_out, cube.bounds(), 1.0), solid_of({}, sheet, 1.0),
                               solid_of({}, nothing, 1.0), solid_of(far_off, sheet, 1.0)}) {
        EXPECT_FALSE(solid.from_geometry);
        EXPECT_GT(solid.mass, 0.0);
        EXPECT_GT(solid.moments.x, 0.0);
        EXPECT_TRUE(std::isfinite(solid.centre.x + solid.moments.z));
    }
    EXPECT_EQ(solid_of({}, sheet, 1.0).centre, centre_of(sheet));
}

TEST(Solid, ANeedlesInertiaCanBeInverted)
{
    const Solid needle = solid_of_mesh(brick_of({1, 1e-5f, 1e-5f}));
    EXPECT_GE(needle.moments.x, 1e-6 * needle.moments.z);
}

}  // namespace
}  // namespace kerf::sim
