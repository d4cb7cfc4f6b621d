#include "viewer/sim/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace kerf::sim {
namespace {

TEST(Camera, PixelsBecomeNormalisedDeviceCoordinatesAsInTheReport)
{
    const glm::dvec2 window(1280, 720);
    EXPECT_EQ(Camera::screen_to_ndc({0, 0}, window), glm::dvec2(-1, 1));
    EXPECT_EQ(Camera::screen_to_ndc({1280, 720}, window), glm::dvec2(1, -1));
    EXPECT_EQ(Camera::screen_to_ndc({640, 360}, window), glm::dvec2(0, 0));
    EXPECT_EQ(Camera::screen_to_ndc({960, 540}, window), glm::dvec2(0.5, -0.5));
}

TEST(Camera, AWindowWithoutAreaGivesItsMiddle)
{
    EXPECT_EQ(Camera::screen_to_ndc({3, 4}, {0, 720}), glm::dvec2(0));
    EXPECT_EQ(Camera::screen_to_ndc({3, 4}, {1280, 0}), glm::dvec2(0));
    for (const double aspect : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), HUGE_VAL})
        EXPECT_EQ(Camera(aspect).projection(), Camera().projection());
}

TEST(Camera, AWindowOf16To9SeesTheStageAndNothingElse)
{
    const Camera camera;
    const glm::dvec2 corner = camera.ndc_to_stage({1, 1});
    EXPECT_NEAR(corner.x, kStageHalfWidth, 1e-9);
    EXPECT_NEAR(corner.y, kStageHalfHeight, 1e-9);
}

TEST(Camera, AnyWindowSeesTheWholeStage)
{
    for (const double aspect : {0.2, 1.0, 4.0 / 3.0, 16.0 / 9.0, 21.0 / 9.0, 10.0}) {
        const glm::dvec2 corner = Camera(aspect).ndc_to_stage({1, 1});
        EXPECT_GE(corner.x, kStageHalfWidth - 1e-9) << aspect;
        EXPECT_GE(corner.y, kStageHalfHeight - 1e-9) << aspect;
        EXPECT_NEAR(corner.x / corner.y, aspect, 1e-9);
    }
}

TEST(Camera, NdcToWorldUndoesViewAndProjection)
{
    const Camera camera(1.5);
    for (const glm::dvec3 p : {glm::dvec3{0, 0, 0}, {3, -2, 1}, {-6, 4, -5}, {0.1, 0.2, 8}}) {
        const glm::dvec4 clip = camera.projection() * camera.view() * glm::dvec4(p, 1);
        EXPECT_NEAR(glm::distance(camera.ndc_to_world(glm::dvec3(clip) / clip.w), p), 0.0, 1e-9);
        EXPECT_NEAR(glm::distance(camera.world_to_ndc(p), glm::dvec3(clip) / clip.w), 0.0, 1e-12);
    }
}

TEST(Camera, AStagePointIsOnTheLineFromTheEyeThroughThePixel)
{
    const Camera camera(2.0);
    const glm::dvec2 window(1000, 500), pixel(137, 411);
    const glm::dvec2 stage = camera.screen_to_stage(pixel, window);
    const glm::dvec3 ndc = camera.world_to_ndc({stage, 0.0});
    EXPECT_NEAR(glm::distance(glm::dvec2(ndc), Camera::screen_to_ndc(pixel, window)), 0.0, 1e-12);
    EXPECT_NEAR(glm::distance(camera.stage_to_screen(stage, window), pixel), 0.0, 1e-9);
}

}  // namespace
}  // namespace kerf::sim
