#include "viewer/sim/cutting_plane.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include "common/support/random.h"
#include "viewer/sim/camera.h"

namespace kerf::sim {
namespace {

struct Placed
{
    MeshPose pose;
    Origin origin;
    WorldPlane plane;
};

// A tumbling object somewhere on stage, its mesh of any size and anywhere, and a stroke across it.
Placed place(std::uint64_t seed)
{
    core::Random random(seed);
    const auto signed_unit = [&] { return 2 * random.unit() - 1; };
    Placed p;
    p.origin.radius = std::pow(10.0, 6 * random.unit() - 3);
    p.origin.centre = 1e4 * p.origin.radius * glm::dvec3(signed_unit(), signed_unit(), signed_unit());
    p.origin.scale = p.pose.scale = 1.1 / p.origin.radius;
    p.pose.rotation =
        glm::mat3_cast(glm::normalize(glm::dquat(signed_unit() + 1e-3, signed_unit(), signed_unit(), signed_unit())));
    const glm::dvec3 middle(5 * signed_unit(), 3 * signed_unit(), signed_unit());
    p.pose.translation = middle - p.pose.scale * (p.pose.rotation * p.origin.centre);
    const glm::dvec2 through = glm::dvec2(middle) + 0.5 * glm::dvec2(signed_unit(), signed_unit());
    const glm::dvec2 along(signed_unit() + 1e-3, signed_unit());
    p.plane = swipe_plane(Camera::eye(), through - along, through + along).value();
    return p;
}

RC_GTEST_PROP(CuttingPlane, IsValidForAnyPoseAndCloserThanAPixelToTheStroke, ())
{
    const Placed p = place(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    const std::optional<Plane> plane = object_plane(p.plane, p.pose, p.origin);
    RC_ASSERT(plane.has_value());
    const glm::dvec3 normal(plane->normal());
    RC_ASSERT(std::abs(glm::length(normal) - 1.0) <= 1e-15 && std::isfinite(plane->offset()));
    // Over the object's ball the two planes differ by less than 2 mm: a sixth of a pixel of 720 rows. The mesh's own
    // float grid at 10 000 radii from its origin is not part of this.
    core::Random random(1);
    for (int i = 0; i < 20; ++i) {
        const glm::dvec3 offset(2 * random.unit() - 1, 2 * random.unit() - 1, 2 * random.unit() - 1);
        const glm::dvec3 point = p.origin.centre + offset / std::sqrt(3.0) * p.origin.radius;
        const double mine = (glm::dot(normal, point) - plane->offset()) * p.pose.scale;
        const double wanted = glm::dot(p.plane.normal, p.pose.to_world(point) - p.plane.point);
        RC_ASSERT(std::abs(mine - wanted) <= 2e-3);
    }
}

RC_GTEST_PROP(CuttingPlane, TheWayBackLeadsToTheStroke, ())
{
    const Placed p = place(*rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
    const WorldPlane back = world_plane(object_plane(p.plane, p.pose, p.origin).value(), p.pose);
    RC_ASSERT(std::abs(glm::length(back.normal) - 1.0) <= 1e-9);
    RC_ASSERT(glm::dot(back.normal, p.plane.normal) >= 1.0 - 1e-5);
}

RC_GTEST_PROP(CuttingPlane, DifferencesInTheLastDigitsOfAPoseSeldomChangeIt, ())
{
    // What the back ends' masses differ by moves a piece by about 1e-7; a grid of 1 / 2048 turns that into a different
    // plane in about one of a thousand cuts.
    const std::uint64_t seed = *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>());
    int same = 0;
    for (std::uint64_t i = 0; i < 50; ++i) {
        Placed p = place(core::Random::mix(seed) + i);
        const Plane one = object_plane(p.plane, p.pose, p.origin).value();
        p.pose.translation += glm::dvec3(1e-7, -1e-7, 1e-7);
        const Plane two = object_plane(p.plane, p.pose, p.origin).value();
        if (one == two) ++same;
    }
    RC_ASSERT(same >= 48);
}

TEST(CuttingPlane, GoesThroughTheEyeAndBothPointsOfTheSwipe)
{
    const glm::dvec2 from(-2, 1), to(3, -0.5);
    const WorldPlane plane = swipe_plane(Camera::eye(), from, to).value();
    EXPECT_NEAR(glm::length(plane.normal), 1.0, 1e-15);
    for (const glm::dvec3 p : {Camera::eye(), glm::dvec3(from, 0), glm::dvec3(to, 0)})
        EXPECT_NEAR(glm::dot(plane.normal, p - plane.point), 0.0, 1e-14);
}

TEST(CuttingPlane, PointsToTheLeftOfTheStroke)
{
    EXPECT_GT(swipe_plane(Camera::eye(), {-1, 0}, {1, 0})->normal.y, 0.0);
    EXPECT_LT(swipe_plane(Camera::eye(), {0, -1}, {0, 1})->normal.x, 0.0);
}

TEST(CuttingPlane, NeedsTwoDifferentPoints)
{
    EXPECT_FALSE(swipe_plane(Camera::eye(), {1, 2}, {1, 2}));
    EXPECT_FALSE(swipe_plane(Camera::eye(), {1, 2}, {1, std::nan("")}));
}

TEST(CuttingPlane, RefusesAPoseThatIsNoPose)
{
    const WorldPlane plane = swipe_plane(Camera::eye(), {0, 0}, {1, 0}).value();
    MeshPose flat;
    flat.scale = 0.0;
    EXPECT_FALSE(object_plane(plane, flat, Origin{}));
    MeshPose lost;
    lost.translation.x = std::nan("");
    EXPECT_FALSE(object_plane(plane, lost, Origin{}));
}

}  // namespace
}  // namespace kerf::sim
