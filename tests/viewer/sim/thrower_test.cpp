#include "viewer/sim/thrower.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "viewer/sim/camera.h"
#include "viewer/sim/world.h"

namespace kerf::sim {
namespace {

std::uint64_t any_seed()
{
    return *rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>());
}

RC_GTEST_PROP(Thrower, StartsOutOfViewAndReachesTheUpperThird, ())
{
    const Flight f = plan_flight(any_seed(), kGravity);
    RC_ASSERT(f.centre.y + kThrownRadius < -kStageHalfHeight);
    RC_ASSERT(f.centre.z == 0.0 && f.motion.velocity.z == 0.0);
    const double rise = f.motion.velocity.y * f.motion.velocity.y / (2 * kGravity);
    RC_ASSERT(std::abs(f.centre.y + rise - f.apex) <= 1e-9);
    RC_ASSERT(f.apex >= kStageHalfHeight / 3 && f.apex + kThrownRadius <= kStageHalfHeight);
}

RC_GTEST_PROP(Thrower, ComesDownInsideTheStage, ())
{
    const Flight f = plan_flight(any_seed(), kGravity);
    const double time = 2 * f.motion.velocity.y / kGravity;
    RC_ASSERT(std::abs(f.centre.x + time * f.motion.velocity.x) + kThrownRadius <= kStageHalfWidth);
    RC_ASSERT(std::abs(f.centre.x) + kThrownRadius <= kStageHalfWidth);
}

RC_GTEST_PROP(Thrower, SpinsALittleAboutAnyAxis, ())
{
    const Flight f = plan_flight(any_seed(), kGravity);
    RC_ASSERT(glm::length(f.motion.spin) >= 0.5 - 1e-9 && glm::length(f.motion.spin) <= 2.0 + 1e-9);
    RC_ASSERT(std::abs(glm::determinant(f.rotation) - 1.0) <= 1e-9);
}

TEST(Thrower, TheSameSeedIsTheSameFlightAndAnotherIsNot)
{
    const Flight a = plan_flight(5, kGravity), b = plan_flight(5, kGravity), c = plan_flight(6, kGravity);
    EXPECT_EQ(a.centre, b.centre);
    EXPECT_EQ(a.rotation, b.rotation);
    EXPECT_EQ(a.motion.velocity, b.motion.velocity);
    EXPECT_EQ(a.motion.spin, b.motion.spin);
    EXPECT_NE(a.centre.x, c.centre.x);
}

}  // namespace
}  // namespace kerf::sim
