#include "viewer/render/fragment_store.h"

#include <gtest/gtest.h>

#include <utility>

#include "back_ends/back_ends.h"
#include "baseline/baseline.h"
#include "common/mesh/triangle_soup.h"
#include "common/shapes/shapes.h"
#include "halfedge/halfedge.h"
#include "support/fixtures.h"
#include "viewer/render/gl_test.h"
#include "viewer/render/pieces_on_stage.h"

namespace kerf::test {

namespace {

using render::DrawnFragment;
using render::FragmentStore;
using render::Room;

/// What the graphics card holds of a buffer.
std::vector<std::byte> read_back(const render::GrowingBuffer& buffer, std::size_t size)
{
    std::vector<std::byte> bytes(size);
    glBindBuffer(GL_COPY_READ_BUFFER, buffer.id());
    glGetBufferSubData(GL_COPY_READ_BUFFER, 0, static_cast<GLsizeiptr>(size), bytes.data());
    glBindBuffer(GL_COPY_READ_BUFFER, 0);
    return bytes;
}

template <typename T>
std::vector<std::byte> bytes_of(std::span<const T> content)
{
    const auto bytes = std::as_bytes(content);
    return {bytes.begin(), bytes.end()};
}

/// The card's buffers are those of the object, byte for byte.
void expect_same_bytes(const DrawnFragment& drawn, const Cuttable& object)
{
    const DrawView view = object.draw_view();
    EXPECT_EQ(read_back(drawn.buffers->vertices, view.vertices.size_bytes()), bytes_of(view.vertices));
    EXPECT_EQ(read_back(drawn.buffers->indices, view.indices.size_bytes()), bytes_of(view.indices));
}

std::unique_ptr<Cuttable> asteroid(const Backend& backend)
{
    return backend.prepare(repaired(shapes::asteroid(10'000, 7))).object;
}

CutResult halves(std::unique_ptr<Cuttable> object, double offset = 0.0)
{
    return cut(std::move(object), *Plane::through({offset, offset, offset}, {1, 2, 3}));
}

class FragmentStoreTest : public GlTest
{
protected:
    render::LookTable looks;
    FragmentStore store{looks};
};

}  // namespace

TEST_F(FragmentStoreTest, UploadsAWholeObjectOnce)
{
    const auto object = asteroid(*halfedge::make_back_end());
    const DrawView view = object->draw_view();
    const std::uint64_t size = view.vertices.size_bytes() + view.indices.size_bytes();
    const DrawnFragment drawn = store.add(*object);
    EXPECT_EQ(store.bytes_uploaded(), size);
    expect_same_bytes(drawn, *object);
    const DrawnFragment again = store.add(*object);
    EXPECT_EQ(store.bytes_uploaded(), size);
    EXPECT_EQ(again.buffers, drawn.buffers);
}

TEST_F(FragmentStoreTest, BringsAnObjectBitByBitAndNeverMoreThanAsked)
{
    constexpr std::uint64_t kMost = 50'000;
    for (const auto& backend : {halfedge::make_back_end(), baseline::make_back_end()}) {
        const auto object = asteroid(*backend);
        const DrawView view = object->draw_view();
        const std::uint64_t size = view.vertices.size_bytes() + view.indices.size_bytes();
        ASSERT_GT(size, 4 * kMost);
        const std::uint64_t before = store.bytes_uploaded();
        render::Arrival arrival;
        std::uint64_t steps = 0;
        for (; !arrival.is_whole && steps < 100; ++steps) {
            const std::uint64_t bytes = store.bring(*object, arrival, kMost);
            EXPECT_EQ(bytes, std::min(kMost, size - steps * kMost));
            EXPECT_NEAR(arrival.share(), double(store.bytes_uploaded() - before) / double(size), 1e-12);
            store.release_unused();
        }
        EXPECT_EQ(steps, (size + kMost - 1) / kMost);
        EXPECT_EQ(store.bytes_uploaded() - before, size);
        // Now it is drawn like any other, and a cut uploads what is new.
        const DrawnFragment drawn = store.add(*object);
        EXPECT_EQ(store.bytes_uploaded() - before, size);
        EXPECT_EQ(drawn.buffers, arrival.buffers);
        expect_same_bytes(drawn, *object);
    }
}

TEST_F(FragmentStoreTest, CountsAndFreesTheBuffersOfWhatIsOnItsWay)
{
    const auto object = asteroid(*halfedge::make_back_end());
    {
        render::Arrival arrival;
        store.bring(*object, arrival, 1000);
        const std::uint64_t held = store.bytes_held();
        EXPECT_GE(held, object->draw_view().vertices.size_bytes());
        EXPECT_LT(held, arrival.bytes) << "the index buffer comes when the vertices are there";
        store.bring(*object, arrival, arrival.bytes);
        ASSERT_TRUE(arrival.is_whole);
        store.release_unused();
        EXPECT_EQ(store.bytes_held(), arrival.bytes) << "all is there, counted once";
    }
    store.release_unused();
    EXPECT_EQ(store.bytes_held(), 0u);
    // What was brought and freed comes anew.
    const DrawnFragment drawn = store.add(*object);
    expect_same_bytes(drawn, *object);
}

TEST_F(FragmentStoreTest, AnObjectThatIsCutOnItsWayComesWithItsPieces)
{
    auto object = asteroid(*halfedge::make_back_end());
    render::Arrival arrival;
    store.bring(*object, arrival, 100'000);
    ASSERT_FALSE(arrival.is_whole);
    const CutResult result = halves(std::move(object));
    ASSERT_EQ(result.status, Status::done);
    const DrawnFragment positive = store.add(*result.positive.front());
    const DrawnFragment negative = store.add(*result.negative.front());
    EXPECT_EQ(positive.buffers, negative.buffers);
    expect_same_bytes(positive, *result.positive.front());
}

TEST_F(FragmentStoreTest, UploadsOfAHalfEdgeCutWhatTheStatisticsSayAndNothingElse)
{
    auto object = asteroid(*halfedge::make_back_end());
    const DrawnFragment whole = store.add(*object, Room::to_grow);
    for (int i = 0; i < 3; ++i) {
        const std::uint64_t before = store.bytes_uploaded();
        CutResult result = halves(std::move(object), 0.05 * i);
        ASSERT_EQ(result.status, Status::done);
        const DrawnFragment positive = store.add(*result.positive.front());
        const DrawnFragment negative = store.add(*result.negative.front());
        EXPECT_EQ(store.bytes_uploaded() - before, result.statistics.bytes_to_upload);
        EXPECT_EQ(positive.buffers, whole.buffers);
        EXPECT_EQ(negative.buffers, whole.buffers);
        expect_same_bytes(positive, *result.positive.front());
        object = std::move(result.positive.front());
    }
    EXPECT_EQ(whole.buffers->vertices.bytes_copied(), 0u);
}

TEST_F(FragmentStoreTest, UploadsOfABaselineCutBothFragmentsWhole)
{
    auto object = asteroid(*baseline::make_back_end());
    const DrawnFragment whole = store.add(*object);
    const std::uint64_t before = store.bytes_uploaded();
    const CutResult result = halves(std::move(object));
    ASSERT_EQ(result.status, Status::done);
    std::uint64_t expected = 0;
    for (const auto* side : {&result.positive, &result.negative}) {
        const IndexedMesh mesh = side->front()->to_indexed_mesh();
        expected += 32 * mesh.vertices.size() + 12 * mesh.triangles.size();
        const DrawnFragment drawn = store.add(*side->front());
        EXPECT_NE(drawn.buffers, whole.buffers);
        expect_same_bytes(drawn, *side->front());
    }
    EXPECT_EQ(store.bytes_uploaded() - before, expected);
    EXPECT_EQ(result.statistics.bytes_to_upload, expected);
}

// Observed once and the same on every machine (the asteroid is, bit for bit): another number here is another cost of a
// cut.
TEST_F(FragmentStoreTest, CountsTheBytesOfACutExactly)
{
    const auto bytes_for = [&](const Backend& backend) {
        auto object = asteroid(backend);
        const DrawnFragment whole = store.add(*object, Room::to_grow);
        const std::uint64_t before = store.bytes_uploaded();
        CutResult result = halves(std::move(object));
        const DrawnFragment positive = store.add(*result.positive.front());
        const DrawnFragment negative = store.add(*result.negative.front());
        return store.bytes_uploaded() - before;
    };
    EXPECT_EQ(bytes_for(*halfedge::make_back_end()), 70'944u);
    EXPECT_EQ(bytes_for(*baseline::make_back_end()), 354'592u);
}

TEST_F(FragmentStoreTest, GrowsOnTheCardAndKeepsWhatIsThere)
{
    auto object = asteroid(*halfedge::make_back_end());
    const DrawnFragment whole = store.add(*object, Room::exact);
    const std::uint64_t before = store.bytes_uploaded();
    CutResult result = halves(std::move(object));
    const DrawnFragment drawn = store.add(*result.positive.front());
    EXPECT_EQ(store.bytes_uploaded() - before, result.statistics.bytes_to_upload);
    EXPECT_GT(whole.buffers->vertices.bytes_copied(), 0u);
    expect_same_bytes(drawn, *result.positive.front());
}

TEST_F(FragmentStoreTest, FreesBuffersWithTheirLastUser)
{
    auto object = asteroid(*halfedge::make_back_end());
    DrawnFragment whole = store.add(*object);
    CutResult result = halves(std::move(object));
    DrawnFragment positive = store.add(*result.positive.front());
    whole = {};
    store.release_unused();
    EXPECT_EQ(store.buffer_sets(), 1u);
    EXPECT_GT(store.bytes_held(), 0u);
    positive = {};
    store.release_unused();
    EXPECT_EQ(store.buffer_sets(), 0u);
    EXPECT_EQ(store.bytes_held(), 0u);
}

TEST_F(FragmentStoreTest, UploadsEverythingAgainWhenTheBuffersWereFreed)
{
    const auto object = asteroid(*halfedge::make_back_end());
    store.add(*object);
    store.release_unused();
    const DrawnFragment drawn = store.add(*object);
    expect_same_bytes(drawn, *object);
}

TEST_F(FragmentStoreTest, MakesOneBatchForEachMaterialAndKind)
{
    std::vector<StagedPiece> pieces = pieces_of("barrel", *halfedge::make_back_end(), 1, 0.0f);
    const DrawnFragment drawn = store.add(*pieces.front().object);
    ASSERT_EQ(drawn.batches.size(), 3u);
    EXPECT_EQ(drawn.batches[0].kind, TriangleKind::surface);
    EXPECT_EQ(drawn.batches[1].kind, TriangleKind::surface);
    EXPECT_EQ(drawn.batches[2].kind, TriangleKind::cap);
    EXPECT_NE(drawn.batches[0].look, drawn.batches[1].look);
    EXPECT_EQ(drawn.triangles, pieces.front().object->triangle_count());
}

}  // namespace kerf::test
