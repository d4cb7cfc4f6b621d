#include "viewer/render/swarm.h"

#include <gtest/gtest.h>
#include <kerf/cut.h>
#include <kerf/fracture.h>

#include <algorithm>
#include <glm/ext/matrix_transform.hpp>
#include <set>

#include "viewer/render/frame_target.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/pieces_on_stage.h"
#include "viewer/render/scene_renderer.h"
#include "viewer/support/stages.h"

namespace kerf::test {

namespace {

using render::Arrival;
using render::DrawnFragment;
using render::DrawnObject;
using render::DrawOptions;
using render::FragmentStore;
using render::Lighting;
using render::Picture;
using render::Swarm;

constexpr render::Kin kKin = 7;

/// A model broken into so many cells, whose pieces fly apart, each turned another way.
std::vector<StagedPiece> broken(const std::string& model, int cells)
{
    StagedPiece whole = std::move(pieces_of(model, "baseline/remap", 0, 0.7f).front());
    FractureOptions options;
    options.cells = cells;
    options.seed = 3;
    Fracture fracture = kerf::fracture(whole.object, options);
    std::vector<StagedPiece> pieces;
    for (std::size_t i = 0; Object* const piece = fracture.piece(i); ++i) {
        const Box box = piece->bounds();
        const glm::vec3 middle =
            0.5f * (glm::vec3(box.lo.x, box.lo.y, box.lo.z) + glm::vec3(box.hi.x, box.hi.y, box.hi.z));
        const float turn = 0.3f * static_cast<float>(pieces.size());
        const glm::mat4 moved = glm::translate(whole.model, 0.3f * middle);
        pieces.push_back(
            {std::move(*piece), glm::rotate(moved, turn, glm::vec3(0.6f, 0.0f, 0.8f)), whole.pattern_scale, {}, true});
    }
    return pieces;
}

class SwarmTest : public GlTest
{
protected:
    std::vector<DrawnFragment> added(std::vector<StagedPiece>& pieces, render::Kin kin)
    {
        std::vector<DrawnFragment> fragments;
        for (StagedPiece& piece : pieces) fragments.push_back(store.add(piece.object, {}, render::Room::exact, kin));
        return fragments;
    }

    Picture picture_of(const std::vector<DrawnObject>& objects, const DrawOptions& options = {})
    {
        target.bind();
        renderer.draw(near_viewpoint(kWidth, kHeight), objects, options, {0, 0, kWidth, kHeight});
        target.resolve();
        return target.read();
    }

    render::LookTable looks;
    FragmentStore store{looks};
    render::SceneRenderer renderer{looks};
    render::FrameTarget target{kWidth, kHeight};
};

/// Pixels that differ.
std::size_t pixels_apart(const Picture& a, const Picture& b)
{
    std::size_t apart = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4)
        apart += !std::equal(a.rgba.begin() + std::ptrdiff_t(i), a.rgba.begin() + std::ptrdiff_t(i) + 4,
                             b.rgba.begin() + std::ptrdiff_t(i));
    return apart;
}

/// Where two pieces that pass through one another are equally far, to the last bit of the depth, the first one drawn is
/// seen: so many pixels of 19 200 at most.
constexpr std::size_t kTies = 0;

}  // namespace

TEST_F(SwarmTest, LooksLikeObjectsThatAreDrawnOneByOne)
{
    render::Kin kin = kKin;
    for (const char* const model : {"barrel", "rook", "car"}) {
        std::vector<StagedPiece> pieces = broken(model, 40), copies = broken(model, 40);
        const std::vector<DrawnFragment> members = added(pieces, kin++), singles = added(copies, 0);
        for (const Lighting lighting : {Lighting::textured, Lighting::lambert}) {
            SCOPED_TRACE(std::string(model) + (lighting == Lighting::lambert ? ", lambert" : ", textured"));
            DrawOptions options;
            options.lighting = lighting;
            options.deferred = false;
            const Picture together = picture_of(drawn(pieces, members), options);
            const Picture one_by_one = picture_of(drawn(copies, singles), options);
            ASSERT_NE(together.rgba, picture_of({}, options).rgba) << "something is seen";
            EXPECT_LE(pixels_apart(together, one_by_one), kTies);
        }
    }
}

TEST_F(SwarmTest, IsDrawnWithACallForEachLookAndOneForItsShadow)
{
    std::vector<StagedPiece> pieces = broken("rook", 200);
    ASSERT_GE(pieces.size(), 200u);
    ASSERT_LE(pieces.size(), Swarm::kMostMembers);
    const std::vector<DrawnFragment> fragments = added(pieces, kKin);
    std::set<std::uint32_t> looks_seen;
    for (const DrawnFragment& fragment : fragments)
        for (const render::DrawBatch& batch : fragment.batches) looks_seen.insert(batch.look);
    picture_of(drawn(pieces, fragments));
    EXPECT_EQ(renderer.statistics().calls, looks_seen.size() + 1);
    EXPECT_GT(renderer.statistics().ranges, 2 * pieces.size()) << "though all of them are drawn";
}

TEST_F(SwarmTest, KnowsItsMembersApart)
{
    std::vector<StagedPiece> pieces = broken("rook", 30);
    const std::vector<DrawnFragment> fragments = added(pieces, kKin);
    std::set<std::uint32_t> numbers;
    for (const DrawnFragment& fragment : fragments) {
        EXPECT_EQ(fragment.buffers, fragments.front().buffers);
        ASSERT_TRUE(fragment.member.has_value());
        EXPECT_TRUE(numbers.insert(*fragment.member).second);
    }
    EXPECT_EQ(store.buffer_sets(), 1u);
}

TEST_F(SwarmTest, MembersAreBroughtAtOnceAndNeverUploadedAgain)
{
    std::vector<StagedPiece> pieces = broken("rook", 30);
    std::vector<Arrival> arrivals(pieces.size());
    std::uint64_t expected = 0;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const DrawView view = view_of(pieces[i].object);
        const std::uint64_t size = view.vertices.size_bytes() + view.indices.size_bytes();
        expected += size;
        EXPECT_EQ(store.bring(pieces[i].object, arrivals[i], 1, render::Room::exact, kKin), size);
        EXPECT_TRUE(arrivals[i].is_whole);
    }
    store.release_unused();
    const std::vector<DrawnFragment> fragments = added(pieces, kKin);
    EXPECT_EQ(store.bytes_uploaded(), expected);
    for (std::size_t i = 0; i < pieces.size(); ++i) EXPECT_EQ(fragments[i].buffers, arrivals[i].buffers);

    std::vector<StagedPiece> copies = broken("rook", 30);
    const std::vector<DrawnFragment> singles = added(copies, 0);
    DrawOptions options;
    options.deferred = false;
    EXPECT_EQ(picture_of(drawn(pieces, fragments), options).rgba, picture_of(drawn(copies, singles), options).rgba);
}

TEST_F(SwarmTest, WhatIsCutFromAMemberIsDrawnByItself)
{
    for (const std::string& back_end : back_end_of_each_kind()) {
        std::vector<StagedPiece> pieces = pieces_of("rook", back_end, 0, 0.7f);
        DrawnFragment whole = store.add(pieces.front().object, {}, render::Room::exact, kKin);
        ASSERT_TRUE(whole.member.has_value());
        Cut result = cut(std::move(pieces.front().object), plane_through({0, 0.1, 0}, {1, 2, 3}));
        ASSERT_EQ(result.status, Status::done);
        Object& half = *result.one(Side::positive);
        const DrawnFragment rest = store.add(half);
        EXPECT_FALSE(rest.member.has_value());
        EXPECT_NE(rest.buffers, whole.buffers);

        std::vector<StagedPiece> copies = pieces_of("rook", back_end, 0, 0.7f);
        Cut copy = cut(std::move(copies.front().object), plane_through({0, 0.1, 0}, {1, 2, 3}));
        const DrawnFragment expected = store.add(*copy.one(Side::positive));
        const auto picture = [&](const DrawnFragment& fragment) {
            DrawnObject object;
            object.fragment = &fragment;
            object.model = copies.front().model;
            return picture_of({object});
        };
        EXPECT_EQ(picture(rest).rgba, picture(expected).rgba);
    }
}

TEST_F(SwarmTest, ThatIsFullIsFollowedByAnother)
{
    const Mesh mesh = shape("box", 12);
    std::vector<Object> objects;
    std::vector<DrawnFragment> fragments;
    for (std::uint32_t i = 0; i < Swarm::kMostMembers + 1; ++i) {
        objects.push_back(object_of(mesh));
        fragments.push_back(store.add(objects.back(), {}, render::Room::exact, kKin));
    }
    EXPECT_EQ(fragments[Swarm::kMostMembers - 1].buffers, fragments.front().buffers);
    EXPECT_NE(fragments.back().buffers, fragments.front().buffers);
    EXPECT_EQ(fragments.back().member, 0u);
}

TEST_F(SwarmTest, HasNoStrangersAndNothingLarge)
{
    Object one = object_of(shape("box", 12)), other = object_of(shape("box", 12)),
           large = object_of(shape("asteroid", 10'000));
    const DrawnFragment first = store.add(one, {}, render::Room::exact, kKin);
    const DrawnFragment second = store.add(other, {}, render::Room::exact, kKin + 1);
    EXPECT_NE(first.buffers, second.buffers);
    ASSERT_GT(view_of(large).vertices.size_bytes(), Swarm::kMostBytesOfAMember);
    EXPECT_FALSE(store.add(large, {}, render::Room::exact, kKin).member.has_value());
}

TEST_F(SwarmTest, IsFreedWithItsLastMember)
{
    std::vector<StagedPiece> pieces = broken("barrel", 5);
    std::vector<Arrival> arrivals(pieces.size());
    for (std::size_t i = 0; i < pieces.size(); ++i)
        store.bring(pieces[i].object, arrivals[i], 1, render::Room::exact, kKin);
    std::vector<DrawnFragment> fragments{store.add(pieces.front().object, {}, render::Room::exact, kKin)};
    arrivals.clear();  // the others are wanted no longer
    store.release_unused();
    EXPECT_GT(store.bytes_held(), 0u);
    fragments.clear();
    store.release_unused();
    EXPECT_EQ(store.bytes_held(), 0u);
    EXPECT_EQ(store.buffer_sets(), 0u);
    // Whose buffers are gone comes anew.
    EXPECT_TRUE(store.add(pieces.back().object, {}, render::Room::exact, kKin).member.has_value());
    EXPECT_GT(store.bytes_held(), 0u);
}

}  // namespace kerf::test
