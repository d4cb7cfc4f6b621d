#include "viewer/inside/moving_plane.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

namespace kerf::inside {
namespace {

/// Its middle is (1, 2, 3), its half diagonal 3.
MovingPlane in_a_box()
{
    return MovingPlane(Box{{0, 0, 1}, {2, 4, 5}});
}

double distance_of_middle(const MovingPlane& plane)
{
    return plane.plane().distance({1, 2, 3});
}

}  // namespace

TEST(MovingPlane, BeginsInTheMiddleAndFacesTheEye)
{
    const MovingPlane plane = in_a_box();
    EXPECT_NEAR(distance_of_middle(plane), 0.0, 1e-12);
    EXPECT_GT(plane.normal().z, 0.5);
    EXPECT_NEAR(glm::length(plane.normal()), 1.0, 1e-12);
}

TEST(MovingPlane, MovesAlongItsNormalAndStaysAtTheModel)
{
    MovingPlane plane = in_a_box();
    plane.move(0.25);
    EXPECT_NEAR(distance_of_middle(plane), -0.75, 1e-12);
    plane.move(5.0);
    EXPECT_NEAR(distance_of_middle(plane), -3.0, 1e-12);
    plane.move(-9.0);
    EXPECT_NEAR(distance_of_middle(plane), 3.0, 1e-12);
}

TEST(MovingPlane, TurnsAboutTheMiddleAndNeverOverTheTop)
{
    MovingPlane plane = in_a_box();
    plane.move(0.5);
    for (int i = 0; i < 20; ++i) {
        plane.turn({0.7, 0.3});
        EXPECT_NEAR(distance_of_middle(plane), -1.5, 1e-12);
    }
    EXPECT_LT(plane.normal().y, 1.0);
    EXPECT_GT(plane.normal().y, 0.99);
}

TEST(MovingPlane, FlippedIsTheSamePlaneFromTheOtherSide)
{
    MovingPlane plane = in_a_box();
    plane.move(0.3);
    const Plane before = plane.plane();
    plane.flip();
    for (const Vec3d& p : {Vec3d(0, 0, 0), Vec3d(1, 2, 3), Vec3d(-4, 5, 9)})
        EXPECT_NEAR(plane.plane().distance(p), -before.distance(p), 1e-12);
    plane.flip();
    EXPECT_NEAR(plane.plane().distance({0, 0, 0}), before.distance({0, 0, 0}), 1e-12);
}

}  // namespace kerf::inside
