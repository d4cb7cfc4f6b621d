#include "viewer/render/screen_rectangle.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

namespace kerf::test {

namespace {

constexpr int kWide = 200, kHigh = 100;

/// Looks along -z from the origin; at a distance of 1 the picture is 4 wide and 2 high.
const glm::mat4 kToClip = glm::frustum(-0.2f, 0.2f, -0.1f, 0.1f, 0.1f, 100.0f);

Box box_at(const glm::vec3& middle, float half)
{
    return {middle - glm::vec3(half), middle + glm::vec3(half)};
}

}  // namespace

TEST(ScreenRectangle, HoldsAllThatIsSeenOfTheBoxAndHardlyMore)
{
    // Its front is 1 away and 0.5 wide: an eighth of the picture's width, a quarter of its height.
    const render::ScreenRectangle part =
        render::screen_rectangle(box_at({0.0f, 0.0f, -1.25f}, 0.25f), kToClip, kWide, kHigh);
    EXPECT_LE(part.x, 87);
    EXPECT_GE(part.x + part.width, 113);
    EXPECT_LE(part.y, 37);
    EXPECT_GE(part.y + part.height, 63);
    EXPECT_LE(part.width, 30);
    EXPECT_LE(part.height, 30);
}

TEST(ScreenRectangle, EndsAtThePicturesEdge)
{
    const render::ScreenRectangle part =
        render::screen_rectangle(box_at({-2.0f, 1.0f, -1.25f}, 0.25f), kToClip, kWide, kHigh);
    EXPECT_EQ(part.x, 0);
    EXPECT_EQ(part.y + part.height, kHigh);
    EXPECT_FALSE(part.is_empty());
}

TEST(ScreenRectangle, IsEmptyBesideThePicture)
{
    for (const glm::vec3 middle : {glm::vec3(5.0f, 0.0f, -1.0f), glm::vec3(-5.0f, 0.0f, -1.0f),
                                   glm::vec3(0.0f, 3.0f, -1.0f), glm::vec3(0.0f, -3.0f, -1.0f)}) {
        const render::ScreenRectangle part = render::screen_rectangle(box_at(middle, 0.25f), kToClip, kWide, kHigh);
        EXPECT_TRUE(part.is_empty());
        EXPECT_EQ(part.pixels(), 0);
    }
}

TEST(ScreenRectangle, IsTheWholePictureForABoxThatReachesBehindTheEye)
{
    const render::ScreenRectangle part =
        render::screen_rectangle(box_at({0.5f, 0.0f, 0.0f}, 0.25f), kToClip, kWide, kHigh);
    EXPECT_EQ(part.x, 0);
    EXPECT_EQ(part.y, 0);
    EXPECT_EQ(part.width, kWide);
    EXPECT_EQ(part.height, kHigh);
}

}  // namespace kerf::test
