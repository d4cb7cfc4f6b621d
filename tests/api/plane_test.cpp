#include <kerf/plane.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace kerf {
namespace {

const double kInfinite = std::numeric_limits<double>::infinity(), kNoNumber = std::numeric_limits<double>::quiet_NaN();

TEST(Plane, GoesThroughItsPointAndHasAUnitNormal)
{
    const Plane plane = Plane::at(Point(1, 2, 3), Normal(0, 0, -5)).value();
    EXPECT_EQ(plane.normal(), Normal(0, 0, -1));
    EXPECT_EQ(plane.offset(), -3.0);
    EXPECT_EQ(plane.distance({7, 7, 1}), 2.0);
    EXPECT_EQ(plane.side_of({7, 7, 1}), Side::positive);
    EXPECT_EQ(plane.side_of({7, 7, 3}), Side::positive) << "what lies on it";
    EXPECT_EQ(plane.side_of({7, 7, 4}), Side::negative);
}

TEST(Plane, OfNumbersThatDescribeNoneIsNothing)
{
    for (const double bad : {kInfinite, -kInfinite, kNoNumber}) {
        EXPECT_FALSE(Plane::at(Point(bad, 0, 0), Normal(1, 0, 0)));
        EXPECT_FALSE(Plane::at(Point(0, 0, 0), Normal(0, bad, 0)));
        EXPECT_FALSE(Plane::from_coefficients(1, 0, 0, bad));
        EXPECT_FALSE(Plane::through({0, 0, 0}, {1, 0, 0}, {0, bad, 0}));
        EXPECT_FALSE(Plane::x(bad));
        EXPECT_FALSE(Plane::z(0.0)->moved(bad));
    }
    EXPECT_FALSE(Plane::at(Point(0, 0, 0), Normal(0, 0, 0)));
    EXPECT_FALSE(Plane::from_coefficients(0, 0, 0, 1));
    EXPECT_FALSE(Plane::through({1, 1, 1}, {2, 2, 2}, {3, 3, 3})) << "points on a line";
    EXPECT_FALSE(Plane::through({1, 1, 1}, {1, 1, 1}, {3, 0, 3}));
}

TEST(Plane, ThroughThreePointsIsPositiveWhereTheyRunCounterClockwise)
{
    const Plane plane = Plane::through({0, 0, 2}, {1, 0, 2}, {0, 1, 2}).value();
    EXPECT_EQ(plane.normal(), Normal(0, 0, 1));
    EXPECT_EQ(plane.offset(), 2.0);
    EXPECT_EQ(Plane::through({0, 0, 2}, {0, 1, 2}, {1, 0, 2})->normal(), Normal(0, 0, -1));
}

TEST(Plane, AcrossAnAxisIsThereWhereTheCoordinateHasThatValue)
{
    EXPECT_EQ(Plane::x(3.0), Plane::at(Point(3, 9, 9), Normal(1, 0, 0)));
    EXPECT_EQ(Plane::y(-2.0), Plane::at(Point(9, -2, 9), Normal(0, 1, 0)));
    EXPECT_EQ(Plane::z(0.5), Plane::at(Point(9, 9, 0.5), Normal(0, 0, 1)));
}

TEST(Plane, OfCoefficientsIsPositiveWhereTheSumIs)
{
    const Plane plane = Plane::from_coefficients(0, 2, 0, -6).value();
    EXPECT_EQ(plane, Plane::y(3.0));
    EXPECT_EQ(plane.side_of({0, 4, 0}), Side::positive);
}

TEST(Plane, FlippedHasTheOtherSides)
{
    const Plane plane = Plane::at(Point(1, 2, 3), Normal(1, 2, 2)).value();
    EXPECT_EQ(plane.flipped().distance({5, 6, 7}), -plane.distance({5, 6, 7}));
    EXPECT_EQ(plane.flipped().flipped(), plane);
}

TEST(Plane, MovedLiesSoFarAlongItsNormal)
{
    EXPECT_EQ(Plane::z(1.0)->moved(0.25), Plane::z(1.25));
    EXPECT_FALSE(Plane::z(std::numeric_limits<double>::max())->moved(std::numeric_limits<double>::max()));
}

/// A matrix that moves, turns, scales, mirrors and shears, and has an inverse.
Mat4d random_matrix(std::mt19937_64& random)
{
    std::uniform_real_distribution<double> number(-2.0, 2.0);
    Mat4d matrix;
    double volume = 0.0;
    do {
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 3; ++row) matrix.m[column][row] = number(random);
        const auto& m = matrix.m;
        volume = m[0][0] * (m[1][1] * m[2][2] - m[2][1] * m[1][2]) - m[1][0] * (m[0][1] * m[2][2] - m[2][1] * m[0][2]) +
                 m[2][0] * (m[0][1] * m[1][2] - m[1][1] * m[0][2]);
    } while (std::abs(volume) < 0.1);
    return matrix;
}

Vec3d times(const Mat4d& matrix, const Vec3d& p)
{
    const auto& m = matrix.m;
    const auto row = [&](int r) { return m[0][r] * p.x + m[1][r] * p.y + m[2][r] * p.z + m[3][r]; };
    return {row(0), row(1), row(2)};
}

RC_GTEST_PROP(Plane, OfTheWorldHasTheSameSidesInTheObject, (std::uint64_t seed))
{
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    const Mat4d matrix = random_matrix(random);
    const Plane world = Plane::at(Point(number(random), number(random), number(random)),
                                  Normal(number(random), number(random), number(random)))
                            .value();
    // The last number of the matrix divides: that of an inverse of floats is hardly ever 1 to the last digit.
    for (const double w : {1.0, 2.0, -2.0, 1.0 + 0x1p-23, 1.0 - 0x1p-24, -1e-3}) {
        Mat4d divided = matrix;
        for (auto& column : divided.m)
            for (double& entry : column) entry *= w;
        const Plane local = world.to_local(divided).value();
        for (int i = 0; i < 20; ++i) {
            const Vec3d p{number(random), number(random), number(random)};
            const double distance = world.distance(times(matrix, p));
            if (std::abs(distance) > 1e-9) RC_ASSERT(local.side_of(p) == world.side_of(times(matrix, p)));
        }
    }
}

TEST(Plane, HasNoPlaceInAnObjectWhoseMatrixHasNoInverse)
{
    Mat4d flat;
    flat.m[2][2] = 0.0;
    EXPECT_FALSE(Plane::x(0.0)->to_local(flat));
    // Columns of which the third is in the plane of the other two, but for rounding.
    for (const auto& [x, y] : {std::pair{2.0, -1.0}, {0.3, 0.7}, {-1.0 / 3.0, 1e5}}) {
        Mat4d dependent;
        for (int i = 0; i < 3; ++i) {
            dependent.m[0][i] = 1.0 + 3 * i;
            dependent.m[1][i] = 2.0 + 3.1 * i;
            dependent.m[2][i] = x * dependent.m[0][i] + y * dependent.m[1][i];
        }
        EXPECT_FALSE(Plane::x(0.0)->to_local(dependent)) << x << ' ' << y;
    }
    Mat4d projection;
    projection.m[0][3] = 1.0;
    EXPECT_FALSE(Plane::x(0.0)->to_local(projection));
    for (const double w : {0.0, kInfinite, -kInfinite, std::nan("")}) {
        Mat4d nowhere;
        nowhere.m[3][3] = w;
        EXPECT_FALSE(Plane::x(0.0)->to_local(nowhere)) << w;
    }
    Mat4d endless;
    endless.m[0][0] = kInfinite;
    EXPECT_FALSE(Plane::x(0.0)->to_local(endless));
}

TEST(Plane, HasAPlaceInAnObjectOfAnyScale)
{
    for (const double scale : {1e-300, 1e-108, 1e-3, 1e103, 1e300}) {
        Mat4d matrix;
        for (int i = 0; i < 3; ++i) matrix.m[i][i] = scale;
        const std::optional<Plane> local = Plane::z(2.0 * scale)->to_local(matrix);
        ASSERT_TRUE(local) << scale;
        EXPECT_NEAR(local->offset(), 2.0, 1e-15) << scale;
    }
    Mat4d flat_and_long;
    flat_and_long.m[0][0] = 1e-200;
    flat_and_long.m[2][2] = 1e200;
    EXPECT_TRUE(Plane::z(0.0)->to_local(flat_and_long));
}

/// A program's own vector: anything with x, y and z converts.
struct GameVector
{
    float x, y, z;
};

TEST(Plane, TakesTheVectorsOfPrograms)
{
    EXPECT_EQ(Plane::at(Point(GameVector{0, 0, 2}), Normal(GameVector{0, 0, 1})), Plane::z(2.0));
    const GameVector up(Plane::z(2.0)->normal()), single(Vec3f(1, 2, 3));
    EXPECT_EQ(Vec3f(up), Vec3f(0, 0, 1));
    EXPECT_EQ(Vec3f(single), Vec3f(1, 2, 3));
}

TEST(Plane, OfTheLargestNumbersIsValid)
{
    constexpr double kMost = std::numeric_limits<double>::max();
    const auto expected = Plane::at(Point(0, 0, 0), Normal(1, 1, 1));
    EXPECT_EQ(Plane::at(Point(0, 0, 0), Normal(kMost, kMost, kMost)), expected);
    EXPECT_EQ(Plane::from_coefficients(kMost, kMost, kMost, 0.0), expected);
    EXPECT_EQ(Plane::from_coefficients(kMost, kMost, kMost, kMost)->offset(), -1.0 / std::sqrt(3.0));
    EXPECT_EQ(Plane::through({-kMost, 0, 0}, {kMost, 0, 0}, {0, kMost, 0}), Plane::z(0.0));
    EXPECT_EQ(Plane::at(Point(0, 0, 0), Normal(std::numeric_limits<double>::infinity(), 0, 0)), std::nullopt);
}

TEST(Plane, OfTheSmallestNumbersIsValid)
{
    constexpr double kLeast = std::numeric_limits<double>::denorm_min();
    for (const double scale : {1.0, 100.0, 1e5, 1e15})
        for (const auto& [a, b, c] :
             {std::array{1.0, 1.0, 0.0}, {1.0, 1.0, 1.0}, {100.0, 77.0, 0.0}, {0.0, 0.0, 1.0}}) {
            const auto plane =
                Plane::from_coefficients(a * scale * kLeast, b * scale * kLeast, c * scale * kLeast, 0.0);
            ASSERT_TRUE(plane);
            const Normal n = plane->normal();
            EXPECT_NEAR(std::hypot(n.x, n.y, n.z), 1.0, 1e-15);
        }
}

}  // namespace
}  // namespace kerf
