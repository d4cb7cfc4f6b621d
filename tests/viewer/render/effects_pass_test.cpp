#include "viewer/render/effects_pass.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "viewer/render/frame_target.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/pieces_on_stage.h"

namespace kerf::test {

namespace {

using render::FlyingSprite;
using render::Picture;
using render::StainSprite;

class EffectsPassTest : public GlTest
{
protected:
    /// Before the wall alone.
    Picture picture_of(const std::vector<StainSprite>& stains, const std::vector<FlyingSprite>& flying)
    {
        target.bind();
        renderer.draw(near_viewpoint(kWidth, kHeight), {}, {}, {0, 0, kWidth, kHeight});
        effects.draw(stains, flying);
        target.resolve();
        return target.read();
    }

    const Picture empty_picture() { return picture_of({}, {}); }

    render::LookTable looks;
    render::SceneRenderer renderer{looks};
    render::EffectsPass effects;
    render::FrameTarget target{kWidth, kHeight};
};

StainSprite red_stain()
{
    return {{0.0f, 0.0f}, 0.6f, 1.0f, {0.7f, 0.02f, 0.02f}, 1.0f, 0.3f};
}

FlyingSprite sprite(FlyingSprite::Kind kind, float z)
{
    return {{0.0f, 0.0f, z}, 0.3f, {0.0f, 0.0f}, 1.0f, static_cast<float>(kind), {0.8f, 0.3f, 0.1f}};
}

std::size_t changed_pixels(const Picture& a, const Picture& b)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        count += std::equal(a.rgba.begin() + std::ptrdiff_t(i), a.rgba.begin() + std::ptrdiff_t(i) + 3,
                            b.rgba.begin() + std::ptrdiff_t(i))
                     ? 0
                     : 1;
    return count;
}

}  // namespace

TEST_F(EffectsPassTest, WithNothingToDrawChangesNothing)
{
    const Picture before = empty_picture();
    EXPECT_EQ(changed_pixels(before, picture_of({}, {})), 0u);
}

TEST_F(EffectsPassTest, AStainIsRedWhereItIsAndNowhereElse)
{
    const Picture before = empty_picture(), after = picture_of({red_stain()}, {});
    const std::uint8_t* const middle = after.pixel(kWidth / 2, kHeight / 2);
    EXPECT_GT(middle[0], 2 * middle[1]);
    EXPECT_GT(changed_pixels(before, after), 200u);
    EXPECT_TRUE(std::equal(before.pixel(3, 3), before.pixel(3, 3) + 3, after.pixel(3, 3)));
}

TEST_F(EffectsPassTest, AFadedStainIsNotSeen)
{
    StainSprite faded = red_stain();
    faded.opacity = 0.0f;
    EXPECT_EQ(changed_pixels(empty_picture(), picture_of({faded}, {})), 0u);
}

TEST_F(EffectsPassTest, TheWallIsSeenThroughAStain)
{
    const Picture before = empty_picture();
    StainSprite thin = red_stain();
    thin.opacity = 0.3f;
    const Picture through = picture_of({thin}, {}), wet = picture_of({red_stain()}, {});
    const auto green = [](const Picture& picture) { return int(picture.pixel(kWidth / 2, kHeight / 2)[1]); };
    EXPECT_LT(green(through), green(before));
    EXPECT_LT(green(wet), green(through));
}

TEST_F(EffectsPassTest, ADryStainDoesNotShine)
{
    StainSprite dry = red_stain();
    dry.wet = 0.0f;
    const auto brightest_green = [](const Picture& picture) {
        int most = 0;
        for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
            if (picture.rgba[i] > 2 * picture.rgba[i + 1] || picture.rgba[i + 1] > 200)
                most = std::max<int>(most, picture.rgba[i + 1]);
        return most;
    };
    EXPECT_LT(brightest_green(picture_of({dry}, {})), brightest_green(picture_of({red_stain()}, {})));
}

TEST_F(EffectsPassTest, StainsOfDifferentShapeDiffer)
{
    StainSprite other = red_stain();
    other.shape = 0.8f;
    EXPECT_GT(changed_pixels(picture_of({red_stain()}, {}), picture_of({other}, {})), 100u);
}

TEST_F(EffectsPassTest, EveryKindIsSeenBeforeTheWallAndHiddenBehindIt)
{
    const Picture before = empty_picture();
    for (const auto kind : {FlyingSprite::juice, FlyingSprite::spark, FlyingSprite::smoke, FlyingSprite::mist}) {
        EXPECT_GT(changed_pixels(before, picture_of({}, {sprite(kind, 0.0f)})), 30u) << kind;
        EXPECT_EQ(changed_pixels(before, picture_of({}, {sprite(kind, -4.0f)})), 0u) << kind;
    }
}

TEST_F(EffectsPassTest, ADropIsAsLongAsItIsFast)
{
    const Picture before = empty_picture();
    FlyingSprite fast = sprite(FlyingSprite::juice, 0.0f);
    fast.stretch = {1.0f, 0.5f};
    EXPECT_GT(changed_pixels(before, picture_of({}, {fast})),
              2 * changed_pixels(before, picture_of({}, {sprite(FlyingSprite::juice, 0.0f)})));
}

}  // namespace kerf::test
