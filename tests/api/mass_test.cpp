#include <kerf/cut.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "api/objects.h"

namespace kerf {
namespace {

const std::string kSomeBackEnd = "linear";

/// A box of 2a x 2b x 2c around the origin.
MassProperties box_mass(float a, float b, float c)
{
    test::Arrays box = test::cube_arrays();
    for (std::array<float, 3>& p : box.positions) p = {p[0] * a, p[1] * b, p[2] * c};
    return test::object_of(test::mesh_of(box), kSomeBackEnd).mass_properties();
}

TEST(MassProperties, OfABoxAreThoseOfTheTextbook)
{
    const MassProperties mass = box_mass(1, 2, 3);
    EXPECT_TRUE(mass.is_of_solid);
    EXPECT_NEAR(mass.volume, 48.0, 1e-9);
    EXPECT_NEAR(mass.inertia.m[0][0], 48.0 / 12.0 * (16.0 + 36.0), 1e-9);
    EXPECT_NEAR(mass.inertia.m[2][2], 48.0 / 12.0 * (4.0 + 16.0), 1e-9);
    EXPECT_NEAR(mass.inertia.m[0][1], 0.0, 1e-9);
    EXPECT_NEAR(mass.mass(2.5), 120.0, 1e-9);
    EXPECT_NEAR(mass.inertia_of(2.5).m[0][0], 2.5 * mass.inertia.m[0][0], 1e-9);
}

Mat4d any_matrix(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> number(-2.0, 2.0);
    Mat4d matrix;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) matrix.m[column][row] = number(random) + (row == column ? 3.0 : 0.0);
    if (number(random) > 0.0)
        for (double& number_of_first : matrix.m[0]) number_of_first = -number_of_first;
    return matrix;
}

RC_GTEST_PROP(MassProperties, PlacedAreThoseOfTheMeshThatTheMatrixMoves, (std::uint64_t seed))
{
    std::mt19937_64 random(seed);
    const Mat4d matrix = any_matrix(random);
    test::Arrays moved = test::cube_arrays();
    const auto& m = matrix.m;
    for (std::array<float, 3>& p : moved.positions) {
        const std::array<float, 3> from = p;
        for (int row = 0; row < 3; ++row)
            p[std::size_t(row)] = float(m[0][row] * double(from[0]) + m[1][row] * double(from[1]) +
                                        m[2][row] * double(from[2]) + m[3][row]);
    }
    const MassProperties placed =
        test::object_of(test::mesh_of(test::cube_arrays()), kSomeBackEnd).mass_properties().placed(matrix);
    const MassProperties measured = test::object_of(test::mesh_of(moved), kSomeBackEnd).mass_properties();
    // A mirrored mesh is turned outside out again by make(), so both volumes are positive.
    const double scale = 1e-4 * (1.0 + measured.volume);
    RC_ASSERT(std::abs(placed.volume - measured.volume) < scale);
    RC_ASSERT(std::abs(placed.centre.x - measured.centre.x) < 1e-4);
    RC_ASSERT(std::abs(placed.centre.y - measured.centre.y) < 1e-4);
    RC_ASSERT(std::abs(placed.centre.z - measured.centre.z) < 1e-4);
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            RC_ASSERT(std::abs(placed.inertia.m[column][row] - measured.inertia.m[column][row]) < 100.0 * scale);
}

RC_GTEST_PROP(PrincipalAxes, TurnTheInertiaIntoItsDiagonal, (std::uint64_t seed))
{
    std::mt19937_64 random(seed);
    const Mat3d inertia = box_mass(1, 2, 3).placed(any_matrix(random)).inertia;
    const PrincipalAxes found = principal_axes(inertia);
    RC_ASSERT(found.moments.x <= found.moments.y && found.moments.y <= found.moments.z);
    const double moments[3] = {found.moments.x, found.moments.y, found.moments.z};
    const double tolerance = 1e-9 * (std::abs(found.moments.z) + 1.0);
    for (int i = 0; i < 3; ++i) {
        const auto& axis = found.axes.m[i];
        RC_ASSERT(std::abs(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2] - 1.0) < 1e-12);
        for (int row = 0; row < 3; ++row) {
            double turned = 0.0;
            for (int column = 0; column < 3; ++column) turned += inertia.m[column][row] * axis[column];
            RC_ASSERT(std::abs(turned - moments[i] * axis[row]) < tolerance);
        }
    }
    const auto& a = found.axes.m;
    const double volume = a[0][0] * (a[1][1] * a[2][2] - a[2][1] * a[1][2]) -
                          a[1][0] * (a[0][1] * a[2][2] - a[2][1] * a[0][2]) +
                          a[2][0] * (a[0][1] * a[1][2] - a[1][1] * a[0][2]);
    RC_ASSERT(std::abs(volume - 1.0) < 1e-12);
}

TEST(MassProperties, OfAnOpenMeshSaySo)
{
    test::Arrays open = test::cube_arrays();
    open.indices.resize(30);
    EXPECT_FALSE(test::object_of(test::mesh_of(open), kSomeBackEnd).mass_properties().is_of_solid);
}

}  // namespace
}  // namespace kerf
