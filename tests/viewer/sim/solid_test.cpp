#include "viewer/sim/solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "viewer/support/stages.h"

namespace kerf::sim {
namespace {

Solid solid_of_mesh(const IndexedMesh& mesh, double scale = 1.0)
{
    return solid_of(mass_properties(mesh), mesh.bounds(), scale);
}

IndexedMesh brick(const glm::vec3& size)
{
    return *repair(shapes::box(size, {1, 1, 1})).mesh;
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
    const Solid solid = solid_of_mesh(brick({1, 2, 3}));
    EXPECT_TRUE(solid.from_geometry);
    EXPECT_NEAR(solid.mass, 6 * kDensity, 1e-6);
    EXPECT_NEAR(solid.moments.x, solid.mass / 12 * (1 + 4), 1e-6);
    EXPECT_NEAR(solid.moments.y, solid.mass / 12 * (1 + 9), 1e-6);
    EXPECT_NEAR(solid.moments.z, solid.mass / 12 * (4 + 9), 1e-6);
}

TEST(Solid, MassGrowsWithTheCubeOfTheScaleAndInertiaWithTheFifthPower)
{
    const IndexedMesh mesh = *test::shape("asteroid");
    const Solid one = solid_of_mesh(mesh), two = solid_of_mesh(mesh, 2.0);
    EXPECT_NEAR(two.mass / one.mass, 8.0, 1e-12);
    EXPECT_NEAR(two.moments.x / one.moments.x, 32.0, 1e-9);
    EXPECT_EQ(two.centre, one.centre);
}

TEST(Solid, PrincipalAxesAreAFrameInWhichTheInertiaIsDiagonal)
{
    for (const char* name : {"asteroid", "l_step", "torus", "comb", "two_legs"}) {
        const IndexedMesh mesh = *test::shape(name);
        const Solid solid = solid_of_mesh(mesh);
        EXPECT_NEAR(glm::determinant(solid.axes), 1.0, 1e-9) << name;
        EXPECT_LE(largest_difference(solid.axes * glm::transpose(solid.axes), glm::dmat3(1.0)), 1e-9) << name;
        EXPECT_LE(solid.moments.x, solid.moments.y) << name;
        EXPECT_LE(solid.moments.y, solid.moments.z) << name;
        const glm::dmat3 expected = mass_properties(mesh).inertia * kDensity;
        EXPECT_LE(largest_difference(solid.inertia(), expected), 1e-9 * solid.moments.z) << name;
    }
}

TEST(Solid, WhatBoundsNoVolumeGetsABoxInstead)
{
    IndexedMesh inside_out = brick({1, 1, 1});
    for (Triangle& t : inside_out.triangles) std::swap(t[0], t[1]);
    Box sheet;
    sheet.add(glm::vec3{-1, 2, 0});
    sheet.add(glm::vec3{1, 3, 0});
    MassProperties far_off;
    far_off.volume = 1.0;
    far_off.centre = {9, 9, 9};
    for (const Solid& solid : {solid_of_mesh(inside_out), solid_of({}, sheet, 1.0), solid_of({}, Box{}, 1.0),
                               solid_of(far_off, sheet, 1.0)}) {
        EXPECT_FALSE(solid.from_geometry);
        EXPECT_GT(solid.mass, 0.0);
        EXPECT_GT(solid.moments.x, 0.0);
        EXPECT_TRUE(std::isfinite(solid.centre.x + solid.moments.z));
    }
    EXPECT_EQ(solid_of({}, sheet, 1.0).centre, sheet.centre());
}

TEST(Solid, ANeedlesInertiaCanBeInverted)
{
    const Solid needle = solid_of_mesh(brick({1, 1e-5f, 1e-5f}));
    EXPECT_GE(needle.moments.x, 1e-6 * needle.moments.z);
}

}  // namespace
}  // namespace kerf::sim
