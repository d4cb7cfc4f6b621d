#include "halfedge/cut/workspace_pool.h"

#include <gtest/gtest.h>

#include <array>

#include "common/shapes/shapes.h"
#include "halfedge/halfedge.h"
#include "support/allocations.h"
#include "support/fixtures.h"

namespace kerf::core::halfedge {
namespace {

const Plane kThroughTheMiddle = *Plane::through({0.01, 0.02, 0.03}, {0.6, 0.64, 0.48});

}  // namespace

TEST(WorkspacePool, LendsTheWorkspaceThatWasUsedLast)
{
    const WorkspacePoolUser user;
    const CutWorkspace *first = nullptr, *second = nullptr;
    {
        const BorrowedWorkspace a, b;
        ASSERT_NE(&*a, &*b);
        first = &*b;  // goes back first
        second = &*a;
    }
    const BorrowedWorkspace again, other;
    EXPECT_EQ(&*again, second);
    EXPECT_EQ(&*other, first);
}

TEST(WorkspacePool, ForgetsItsMemoryWithItsLastUser)
{
    const auto room = [] {
        const std::size_t before = ::kerf::test::allocated_bytes();
        make_room_for_cut(100'000);
        return ::kerf::test::allocated_bytes() - before;
    };
    std::size_t cold = 0;
    {
        const WorkspacePoolUser first;
        const WorkspacePoolUser second;
        cold = room();
        EXPECT_GT(cold, 100'000u);
        EXPECT_EQ(room(), 0u) << "it is there";
    }
    const WorkspacePoolUser later;
    EXPECT_EQ(room(), cold) << "and gone";
}

TEST(WorkspacePool, MakesTheFirstCutOfACloneAsCheapAsAnyOther)
{
    const auto object = std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(2000, 1))).object);
    const auto allocations_of_cut = [&] {
        std::unique_ptr<Cuttable> copy = object->clone();
        const std::uint64_t before = ::kerf::test::allocations();
        const CutResult result = cut(std::move(copy), kThroughTheMiddle);
        EXPECT_EQ(result.status, Status::done);
        return ::kerf::test::allocations() - before;
    };
    const std::uint64_t first = allocations_of_cut(), second = allocations_of_cut();
    EXPECT_LE(second, first);
    EXPECT_EQ(allocations_of_cut(), second);
    EXPECT_LE(second, 24u) << "results and their loops, but no scratch";
}

TEST(WorkspacePool, KeepsCutsOfDifferentUniversesApart)
{
    // One workspace plans them all in turn: what one cut leaves in it must mean nothing to the next.
    const auto a = std::move(make_back_end()->prepare(test::closed_shape("comb")).object);
    const auto b = std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(2000, 1))).object);
    const auto pieces = [](const Cuttable& object, const Plane& plane) {
        CutOptions apart;
        apart.split_components = true;
        std::vector<IndexedMesh> meshes;
        CutResult result = cut(object.clone(), plane, apart);
        for (auto* side : {&result.positive, &result.negative})
            for (auto& piece : *side) {
                CutResult again = cut(std::move(piece), *Plane::through({0.0, 0.05, 0.0}, {0.0, 0.6, 0.8}), apart);
                for (const auto* half : {&again.positive, &again.negative})
                    for (const auto& part : *half) meshes.push_back(part->to_indexed_mesh());
            }
        return meshes;
    };
    const auto expect_equal = [](const std::vector<IndexedMesh>& x, const std::vector<IndexedMesh>& y) {
        ASSERT_EQ(x.size(), y.size());
        for (std::size_t i = 0; i < x.size(); ++i) {
            EXPECT_TRUE(x[i].triangles == y[i].triangles);
            ASSERT_EQ(x[i].vertices.size(), y[i].vertices.size());
            for (std::size_t v = 0; v < x[i].vertices.size(); ++v)
                ASSERT_EQ(x[i].vertices[v].position, y[i].vertices[v].position);
        }
    };
    const std::vector<IndexedMesh> of_a = pieces(*a, kThroughTheMiddle), of_b = pieces(*b, kThroughTheMiddle);
    ASSERT_GE(of_a.size(), 2u);
    for (int round = 0; round < 3; ++round) {
        expect_equal(pieces(*b, kThroughTheMiddle), of_b);
        expect_equal(pieces(*a, kThroughTheMiddle), of_a);
    }
}

}  // namespace kerf::core::halfedge
