#include <kerf/cut.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <thread>

#include "api/objects.h"

namespace kerf {
namespace {

class DrawTest : public testing::TestWithParam<std::string>
{
};
INSTANTIATE_TEST_SUITE_P(All, DrawTest, testing::ValuesIn(test::back_end_names()),
                         [](const auto& param) { return param.param; });

DrawView drawn(const Object& object)
{
    DrawView view;
    EXPECT_EQ(object.draw(view), Status::done);
    return view;
}

TEST_P(DrawTest, RangesAreTheObject)
{
    Cut result = cut(test::object_of(test::shape("torus"), GetParam()), Plane::x(0.1).value());
    for (const Side side : {Side::negative, Side::positive}) {
        const Object& piece = *result.one(side);
        const DrawView view = drawn(piece);
        std::uint64_t indices = 0;
        for (const DrawRange& range : view.ranges) {
            indices += range.index_count;
            ASSERT_LE(range.first_index + range.index_count, view.indices.size());
            for (const std::uint32_t i : view.indices.subspan(range.first_index, range.index_count)) {
                ASSERT_LT(i, view.vertices.size());
                const float x = view.vertices[i].position.x;
                EXPECT_TRUE(side == Side::positive ? x >= 0.1f : x <= 0.1f);
                if (range.kind == TriangleKind::cap) {
                    EXPECT_EQ(x, 0.1f);
                }
            }
            EXPECT_LT(range.material, piece.material_count());
        }
        EXPECT_EQ(indices, 3 * piece.triangle_count());
    }
}

TEST_P(DrawTest, OnlyWhatIsNewIsToBeUploaded)
{
    Object object = test::object_of(test::shape("torus"), GetParam());
    DrawView view = drawn(object);
    EXPECT_EQ(view.new_vertices_from, 0u);
    EXPECT_EQ(view.new_indices_from, 0u);
    object.mark_uploaded(view);
    EXPECT_EQ(object.draw(view), Status::done);
    EXPECT_EQ(view.new_vertices_from, view.vertices.size());
    EXPECT_EQ(view.new_indices_from, view.indices.size());
    const std::uint64_t buffers = view.buffers;
    Cut result = cut(std::move(object), Plane::x(0.1).value());
    const DrawView after = drawn(*result.one(Side::positive));
    if (after.buffers == buffers) {
        EXPECT_GT(after.new_vertices_from, 0u) << "the rest is on the GPU";
        EXPECT_EQ((after.vertices.size() - after.new_vertices_from) * sizeof(DrawVertex) +
                      (after.indices.size() - after.new_indices_from) * sizeof(std::uint32_t),
                  result.statistics().bytes_to_upload);
    } else {
        EXPECT_EQ(after.new_vertices_from, 0u);
    }
}

TEST_P(DrawTest, ViewsShowTheStreams)
{
    test::Arrays cube = test::cube_arrays();
    std::vector<float> heat;
    for (const auto& p : cube.positions) heat.push_back(p[0]);
    const StreamInput stream{"heat", heat.data(), 1};
    MeshInput input = cube.input();
    input.streams = {&stream, 1};
    Cut result = cut(test::object_of(*Mesh::make(input), GetParam()), Plane::x(0.25).value());
    const DrawView view = drawn(*result.one(Side::positive));
    ASSERT_EQ(view.streams.size(), 1u);
    EXPECT_STREQ(view.streams[0].name, "heat");
    ASSERT_EQ(view.streams[0].values.size(), view.vertices.size());
    for (const DrawRange& range : view.ranges)
        for (const std::uint32_t i : view.indices.subspan(range.first_index, range.index_count))
            EXPECT_EQ(view.streams[0].values[i], view.vertices[i].position.x) << "interpolated as the positions are";
}

TEST_P(DrawTest, StaysWhereItIsWhileRelativesAreCut)
{
    Cut result = cut(test::object_of(test::shape("torus", 20'000), GetParam()), Plane::x(0.0).value());
    Object &still = *result.one(Side::negative), &other = *result.one(Side::positive);
    const DrawView view = drawn(still);
    std::vector<std::uint32_t> indices;
    for (const DrawRange& range : view.ranges)
        for (const std::uint32_t i : view.indices.subspan(range.first_index, range.index_count)) indices.push_back(i);
    std::thread cutting([&] {
        Object object = std::move(other);
        for (int i = 1; i < 20; ++i) {
            Cut next = cut(std::move(object), test::plane_at(0, 0, 0.01 * i, 0.02, 0.03, 1.0));
            object = ok(next.status) ? std::move(*next.one(Side::positive)) : std::move(next.object);
        }
    });
    std::size_t changed = 0;
    for (int times = 0; times < 50; ++times) {
        std::size_t at = 0;
        for (const DrawRange& range : view.ranges)
            for (const std::uint32_t i : view.indices.subspan(range.first_index, range.index_count))
                changed += i != indices[at++] || view.vertices[i].position.x > 1e-6f ? 1 : 0;
    }
    cutting.join();
    EXPECT_EQ(changed, 0u);
}

TEST_P(DrawTest, TellsOnceWhenBuffersAreGone)
{
    std::multiset<std::uint64_t> released;
    std::set<std::uint64_t> seen;
    const auto look = [&](const Object& object) { seen.insert(drawn(object).buffers); };
    {
        PrepareOptions options;
        options.back_end_name = GetParam().c_str();
        options.listener.user = &released;
        options.listener.released = [](void* user, std::uint64_t buffers) {
            static_cast<std::multiset<std::uint64_t>*>(user)->insert(buffers);
        };
        Object object = *prepare(test::shape("torus"), options);
        look(object);
        Object copy = *object.clone();
        look(copy);
        Cut result = cut(std::move(object), Plane::x(0.1).value());
        look(*result.one(Side::positive));
        look(*result.one(Side::negative));
        EXPECT_EQ(result.one(Side::positive)->compact(), Status::done);
        look(*result.one(Side::positive));
        for (const std::uint64_t buffers : released) {
            EXPECT_NE(drawn(copy).buffers, buffers);
            EXPECT_NE(drawn(*result.one(Side::positive)).buffers, buffers);
            EXPECT_NE(drawn(*result.one(Side::negative)).buffers, buffers);
        }
    }
    for (const std::uint64_t buffers : seen) EXPECT_EQ(released.count(buffers), 1u);
}

}  // namespace
}  // namespace kerf
