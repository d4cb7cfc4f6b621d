#include "common/mesh/plane.h"
#include "common/mesh/plane_frame.h"
#include "common/mesh/plane_noise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace kerf::core {
namespace {

TEST(Plane, SignedDistanceGrowsAlongTheNormal)
{
    const Plane plane = *Plane::through({0, 0, 2}, {0, 0, 5});
    EXPECT_EQ(plane.signed_distance({7, 8, 3}), 1.0);
    EXPECT_EQ(plane.signed_distance({7, 8, 2}), 0.0);
    EXPECT_EQ(plane.signed_distance({7, 8, -1}), -3.0);
}

TEST(Plane, NeedsADirectionAndFiniteNumbers)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    EXPECT_FALSE(Plane::through({0, 0, 0}, {0, 0, 0}));
    EXPECT_FALSE(Plane::through({0, 0, 0}, {0, nan, 1}));
    EXPECT_FALSE(Plane::through({0, inf, 0}, {0, 1, 1}));
    EXPECT_TRUE(Plane::through({0, 0, 0}, {0, 1e-300, 0}));
}

TEST(Plane, RangeOfABoxIsAttainedAtItsCorners)
{
    const Plane plane = *Plane::through({0.1, 0.2, 0.3}, {1, -2, 3});
    Box box;
    box.add(glm::vec3{-1, -2, -3});
    box.add(glm::vec3{4, 5, 6});
    const auto [least, most] = plane.distance_range(box);
    EXPECT_EQ(least, plane.signed_distance({-1, 5, -3}));
    EXPECT_EQ(most, plane.signed_distance({4, -2, 6}));
}

TEST(PlaneFrame, IsRightHandedAndUnit)
{
    for (const glm::dvec3 direction : {glm::dvec3{0, 0, 1}, {1, 0, 0}, {0, -1, 0}, {1, 2, 3}, {1, 1, 1}}) {
        const glm::dvec3 n = glm::normalize(direction);
        const PlaneFrame frame = PlaneFrame::of(n);
        EXPECT_NEAR(glm::length(frame.u), 1.0, 1e-15);
        EXPECT_NEAR(glm::dot(frame.u, n), 0.0, 1e-15);
        EXPECT_NEAR(glm::length(glm::cross(frame.u, frame.v) - n), 0.0, 1e-15);
    }
}

TEST(PlaneNoise, IsFourUnitsInTheLastPlace)
{
    EXPECT_EQ(plane_noise(1.0f), 4.0 * std::numeric_limits<float>::epsilon());
}

TEST(PlaneNoise, IsThatOfTheNeighbourBelowAtTheLargestFloat)
{
    EXPECT_EQ(plane_noise(std::numeric_limits<float>::max()), 4.0 * 0x1p104);
    EXPECT_EQ(plane_noise(0x1p127f), 4.0 * 0x1p104) << "the smallest float of that step";
}

TEST(PlaneFrame, GivesUvThatFloatsCanHold)
{
    constexpr float kLargest = std::numeric_limits<float>::max();
    const PlaneFrame frame = PlaneFrame::of(glm::normalize(glm::dvec3(1, 2, 3)));
    for (const float x : {-kLargest, kLargest})
        for (const float y : {-kLargest, kLargest})
            for (const float z : {-kLargest, kLargest}) {
                const glm::vec2 uv = frame.uv({x, y, z});
                EXPECT_LE(std::abs(uv.x), kLargest);
                EXPECT_LE(std::abs(uv.y), kLargest);
            }
    const glm::vec3 p(0.1f, -7.0f, 3e5f);
    EXPECT_EQ(frame.uv(p), glm::vec2(glm::dot(frame.u, glm::dvec3(p)), glm::dot(frame.v, glm::dvec3(p))));
}

}  // namespace
}  // namespace kerf::core
