// Objects that share buffers: who does, how one gets out of it, and that nothing of it shows in what cuts give.

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "common/cutting/cut.h"
#include "support/backends.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core {
namespace {

using Bytes = std::vector<std::uint32_t>;

void append(Bytes& bytes, double value)
{
    const auto bits = std::bit_cast<std::uint64_t>(value);
    bytes.push_back(static_cast<std::uint32_t>(bits));
    bytes.push_back(static_cast<std::uint32_t>(bits >> 32));
}

/// The mesh, its materials and the outline of the last cut.
Bytes bytes_of(const Cuttable& object)
{
    const IndexedMesh mesh = object.to_indexed_mesh();
    Bytes bytes = referee::bytes_of(mesh);
    for (const Material& material : mesh.materials)
        bytes.insert(bytes.end(), material.name.begin(), material.name.end());
    for (const SectionLoop& loop : object.section_loops()) {
        bytes.push_back(static_cast<std::uint32_t>(loop.points.size()) * 2 + loop.closed);
        for (const glm::vec3& p : loop.points)
            for (int axis = 0; axis < 3; ++axis) bytes.push_back(std::bit_cast<std::uint32_t>(p[axis]));
    }
    return bytes;
}

/// What is drawn, in terms of vertices: where in the buffers it lies does not show.
Bytes bytes_of(const DrawView& view)
{
    Bytes bytes{static_cast<std::uint32_t>(view.materials.size())};
    for (const DrawRange& range : view.ranges) {
        bytes.insert(bytes.end(), {range.index_count, range.material, static_cast<std::uint32_t>(range.kind)});
        for (const std::uint32_t i : view.indices.subspan(range.first_index, range.index_count))
            for (int axis = 0; axis < 3; ++axis)
                bytes.push_back(std::bit_cast<std::uint32_t>(view.vertices[i].position[axis]));
    }
    return bytes;
}

CutResult halves_of(const Backend& backend, const char* shape)
{
    return cut(backend.prepare(test::closed_shape(shape)).object, *Plane::through({0.05, 0.1, 0.02}, {1, 2, 3}));
}

class Relatives : public testing::TestWithParam<test::NamedBackend>
{
protected:
    std::unique_ptr<Backend> backend_ = GetParam().make();
};

INSTANTIATE_TEST_SUITE_P(BackEnds, Relatives, testing::ValuesIn(test::backends()),
                         [](const auto& parameter) { return parameter.param.name; });

TEST_P(Relatives, ShareTheBuffersThatTheyDrawFrom)
{
    const CutResult halves = halves_of(*backend_, "torus");
    const Cuttable &one = *halves.positive.at(0), &other = *halves.negative.at(0);
    EXPECT_TRUE(one.shares_buffers_with(one));
    EXPECT_EQ(one.shares_buffers_with(other), GetParam().name == "halfedge");
    EXPECT_EQ(one.shares_buffers_with(other), one.draw_view().buffers == other.draw_view().buffers);
    EXPECT_EQ(one.shares_buffers_with(other), other.shares_buffers_with(one));

    EXPECT_FALSE(one.shares_buffers_with(*one.clone()));
    EXPECT_FALSE(one.shares_buffers_with(*backend_->prepare(test::closed_shape("torus")).object));
    for (const test::NamedBackend& any : test::backends())
        EXPECT_FALSE(one.shares_buffers_with(*any.make()->prepare(test::closed_shape("torus")).object)) << any.name;
}

TEST_P(Relatives, AreStrangersOnceOneIsDetached)
{
    for (const char* shape : {"torus", "comb", "uv_sphere", "sphere_in_sphere"}) {
        SCOPED_TRACE(shape);
        const CutResult halves = halves_of(*backend_, shape);
        Cuttable &one = *halves.positive.at(0), &other = *halves.negative.at(0);
        const Bytes one_before = bytes_of(one), other_before = bytes_of(other);
        const std::uint64_t buffers = other.draw_view().buffers;
        const bool shared = one.shares_buffers_with(other);
        one.mark_uploaded(one.draw_view());
        EXPECT_EQ(one.detach(), Status::done);
        EXPECT_FALSE(one.shares_buffers_with(other));
        EXPECT_NE(one.draw_view().buffers, buffers);
        EXPECT_EQ(other.draw_view().buffers, buffers);
        EXPECT_EQ(bytes_of(one), one_before);
        EXPECT_EQ(bytes_of(other), other_before);
        EXPECT_EQ(one.draw_view().new_vertex_bytes.empty(), !shared) << "what was moved is to be uploaded again";
    }
}

TEST_P(Relatives, WhatACutAddsAfterAViewIsNewAfterThatViewIsUploaded)
{
    for (const char* shape : {"torus", "comb", "uv_sphere"}) {
        SCOPED_TRACE(shape);
        CutResult halves = halves_of(*backend_, shape);
        Cuttable& one = *halves.positive.at(0);
        const bool shared = one.shares_buffers_with(*halves.negative.at(0));
        const DrawView view = one.draw_view();
        const glm::dvec3 centre = halves.negative.at(0)->bounds().centre();
        const CutResult again = cut(std::move(halves.negative.at(0)), *Plane::through(centre, {3, -1, 2}));
        ASSERT_FALSE(again.positive.empty());
        one.mark_uploaded(view);
        EXPECT_EQ(one.draw_view().new_vertex_bytes.empty(), !shared);
        one.mark_uploaded(one.draw_view());
        EXPECT_TRUE(one.draw_view().new_vertex_bytes.empty());
        one.mark_uploaded(view);
        EXPECT_TRUE(one.draw_view().new_vertex_bytes.empty()) << "an older view takes nothing back";
    }
}

TEST_P(Relatives, WhatSharesNothingIsDetachedAlready)
{
    CutResult halves = halves_of(*backend_, "torus");
    halves.negative.clear();
    Cuttable& alone = *halves.positive.at(0);
    alone.mark_uploaded(alone.draw_view());
    const std::uint64_t buffers = alone.draw_view().buffers;
    const Vertex* const vertices = alone.draw_view().vertices.data();
    EXPECT_EQ(alone.detach(), Status::done);
    EXPECT_EQ(alone.draw_view().buffers, buffers);
    EXPECT_EQ(alone.draw_view().vertices.data(), vertices);
    EXPECT_TRUE(alone.draw_view().new_vertex_bytes.empty());
}

/// Who keeps buffers on a graphics card under their number never takes a new object for one that is gone.
TEST_P(Relatives, BuffersAreNeverNumberedTwice)
{
    std::set<std::uint64_t> seen;
    for (int i = 0; i < 50; ++i) {
        const CutResult halves = halves_of(*backend_, "cube");
        const std::unique_ptr<Cuttable> copy = halves.positive.at(0)->clone();
        ASSERT_EQ(halves.negative.at(0)->detach(), Status::done);
        for (const Cuttable* object : {halves.positive.at(0).get(), halves.negative.at(0).get(), copy.get()})
            EXPECT_TRUE(seen.insert(object->draw_view().buffers).second);
    }
}

TEST_P(Relatives, ADrawViewOutlivesCutsOfWhatWasDetached)
{
    CutResult halves = halves_of(*backend_, "torus");
    const DrawView view = halves.negative.at(0)->draw_view();
    const Bytes before = bytes_of(view);
    ASSERT_EQ(halves.positive.at(0)->detach(), Status::done);
    EXPECT_EQ(bytes_of(view), before);
    std::unique_ptr<Cuttable> object = std::move(halves.positive.at(0));
    for (int i = 0; i < 20; ++i) {
        const Plane plane = *Plane::through(object->bounds().centre(), {1, 2, 3 - i});
        CutResult result = cut(std::move(object), plane);
        object = std::move(result.object ? result.object : result.positive.at(0));
    }
    EXPECT_EQ(bytes_of(view), before);
}

// ----- same object, same plane, same bytes, whatever relatives go through -----

/// What is done to an object follows from its place in the family alone: `path` names that place.
struct Member
{
    std::uint64_t path;
    std::unique_ptr<Cuttable> object;
};

/// What each member was when it was made, and what came of its cut.
struct Chronicle
{
    std::map<std::uint64_t, Bytes> made, cut;
};

/// Cuts a member by a plane and with options that depend on its path, and notes what came of it.
std::vector<Member> cut_member(Member member, Chronicle& chronicle)
{
    EXPECT_EQ(bytes_of(*member.object), chronicle.made.at(member.path)) << "only relatives were cut since";
    test::Random random(member.path);
    const Plane plane = *Plane::through(member.object->bounds().centre(), random.direction());
    CutOptions options;
    options.build_caps = random.below(2) == 0;
    options.split_components = random.below(2) == 0;
    if (random.below(2) == 0) options.cap_material = random.below(4);  // some of them do not exist
    CutResult result = cut(std::move(member.object), plane, options);

    Bytes& bytes = chronicle.cut[member.path];
    bytes = {static_cast<std::uint32_t>(result.status), static_cast<std::uint32_t>(result.positive.size()),
             result.caps_exceed_section, static_cast<std::uint32_t>(result.statistics.crossing_triangles)};
    append(bytes, result.section_area);
    std::vector<Member> pieces;
    if (result.object) return pieces;
    std::uint64_t path = 100 * member.path;
    for (auto* side : {&result.positive, &result.negative})
        for (auto& piece : *side) {
            chronicle.made[++path] = bytes_of(*piece);
            pieces.push_back({path, std::move(piece)});
        }
    return pieces;
}

constexpr std::uint64_t kFamilies = 4, kGenerations = 3;

std::uint64_t generation(std::uint64_t path)
{
    return path < 100 ? 0 : 1 + generation(path / 100);
}

enum class Order
{
    depth_first,
    breadth_first,
    backwards,
    shuffled,
};

/// Cuts families that descend from a mesh until the last generation, one member after the other in the order asked for.
/// `before` is called with each member before it is cut.
template <class Before>
Chronicle cut_family(const Backend& backend, const IndexedMesh& mesh, Order order, Before before)
{
    Chronicle chronicle;
    std::vector<Member> waiting;
    for (std::uint64_t path = 1; path <= kFamilies; ++path) {
        waiting.push_back({path, backend.prepare(mesh).object});
        chronicle.made[path] = bytes_of(*waiting.back().object);
    }
    test::Random random(5);
    while (!waiting.empty()) {
        const std::size_t next = order == Order::breadth_first ? 0
                                 : order == Order::shuffled ? random.below(static_cast<std::uint32_t>(waiting.size()))
                                                            : waiting.size() - 1;
        Member member = std::move(waiting[next]);
        waiting.erase(waiting.begin() + static_cast<std::ptrdiff_t>(next));
        before(member);
        std::vector<Member> pieces = cut_member(std::move(member), chronicle);
        if (order == Order::backwards) std::reverse(pieces.begin(), pieces.end());
        for (Member& piece : pieces)
            if (generation(piece.path) < kGenerations) waiting.push_back(std::move(piece));
    }
    return chronicle;
}

Chronicle cut_family(const Backend& backend, const IndexedMesh& mesh, Order order)
{
    return cut_family(backend, mesh, order, [](Member&) {});
}

template <class Check>
void for_each_shape(Check check)
{
    for (const auto* shapes : {&test::closed_shapes(), &test::open_shapes()})
        for (const test::NamedMesh& shape : *shapes) {
            SCOPED_TRACE(shape.name);
            check(shape.mesh);
            if (testing::Test::HasFailure()) return;
        }
}

void expect_same(const Chronicle& found, const Chronicle& expected)
{
    EXPECT_GT(expected.cut.size(), kFamilies);
    EXPECT_TRUE(found.made == expected.made);
    EXPECT_TRUE(found.cut == expected.cut);
}

TEST_P(Relatives, AreCutInAnyOrderWithTheSameBytes)
{
    for_each_shape([&](const IndexedMesh& mesh) {
        const Chronicle expected = cut_family(*backend_, mesh, Order::depth_first);
        for (const Order order : {Order::breadth_first, Order::backwards, Order::shuffled})
            expect_same(cut_family(*backend_, mesh, order), expected);
    });
}

TEST_P(Relatives, AreCutWithTheSameBytesDetachedOrNot)
{
    for_each_shape([&](const IndexedMesh& mesh) {
        const Chronicle expected = cut_family(*backend_, mesh, Order::depth_first);
        expect_same(cut_family(*backend_, mesh, Order::shuffled,
                               [](Member& member) { ASSERT_EQ(member.object->detach(), Status::done); }),
                    expected);
    });
}

TEST_P(Relatives, CopiesOfThemAreCutWithTheSameBytes)
{
    for_each_shape([&](const IndexedMesh& mesh) {
        const Chronicle expected = cut_family(*backend_, mesh, Order::depth_first);
        expect_same(cut_family(*backend_, mesh, Order::breadth_first,
                               [](Member& member) { member.object = member.object->clone(); }),
                    expected);
    });
}

}  // namespace
}  // namespace kerf::core
