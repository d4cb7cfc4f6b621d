#include "viewer/render/rehearsal.h"

#include <gtest/gtest.h>

#include "viewer/render/frame_target.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/pieces_on_stage.h"
#include "viewer/render/scene_renderer.h"

namespace kerf::test {

namespace {

class RehearsalTest : public GlTest
{
protected:
    render::Picture picture_of(std::span<const render::DrawnObject> objects)
    {
        target.bind();
        renderer.draw(near_viewpoint(kWidth, kHeight), objects, {}, {0, 0, kWidth, kHeight});
        target.resolve();
        return target.read();
    }

    std::uint32_t look_of(const char* name, TriangleKind kind)
    {
        const Material material{name};
        return looks.index_of(std::span(&material, 1), 0, kind);
    }

    render::LookTable looks;
    render::SceneRenderer renderer{looks};
    render::FrameTarget target{kWidth, kHeight};
};

}  // namespace

TEST_F(RehearsalTest, ManySpecksAreDrawnAndNothingIsSeenOfThem)
{
    const render::Picture empty = picture_of({});
    const render::Rehearsal rehearsal({look_of("wood", TriangleKind::surface), look_of("stone", TriangleKind::surface)},
                                      {look_of("cap", TriangleKind::cap)}, 300);
    EXPECT_GE(rehearsal.objects().size(), 300u) << "as many as the pieces of something that breaks";
    const render::Picture rehearsed = picture_of(rehearsal.objects());
    EXPECT_GE(renderer.statistics().calls, 2 * 300u) << "each throws a shadow, too";
    EXPECT_EQ(rehearsed.rgba, empty.rgba);
    EXPECT_EQ(picture_of({}).rgba, empty.rgba) << "and nothing is left behind";
}

TEST_F(RehearsalTest, EachLookIsShadedInAllWays)
{
    const std::uint32_t look = look_of("wood", TriangleKind::surface);
    const render::Rehearsal rehearsal({look}, {}, 300);
    bool has_few = false, has_many = false, has_members = false;
    for (const render::DrawnObject& object : rehearsal.objects()) {
        ASSERT_EQ(object.fragment->batches.size(), 1u);
        EXPECT_EQ(object.fragment->batches.front().look, look);
        (object.fragment->triangles > 1 ? has_many : has_few) = true;
        has_members |= object.fragment->member.has_value();
    }
    EXPECT_TRUE(has_few);
    EXPECT_TRUE(has_many);
    EXPECT_TRUE(has_members);
}

TEST_F(RehearsalTest, NeedsNoSwarmWhereLittleBreaks)
{
    const std::uint32_t look = look_of("wood", TriangleKind::surface);
    const render::Rehearsal rehearsal({look}, {}, render::Swarm::kFewestMembers - 1);
    for (const render::DrawnObject& object : rehearsal.objects()) EXPECT_FALSE(object.fragment->member.has_value());
}

TEST_F(RehearsalTest, WithoutLooksThereIsNothingToDraw)
{
    const render::Rehearsal rehearsal({}, {}, 300);
    EXPECT_TRUE(rehearsal.objects().empty());
}

}  // namespace kerf::test
