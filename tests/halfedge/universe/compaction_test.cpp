// Compacting changes where things lie, and nothing else.

#include <gtest/gtest.h>

#include "common/shapes/shapes.h"
#include "halfedge/consistency.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core::halfedge {
namespace {

/// The larger side after a few cuts through the middle.
std::unique_ptr<Cuttable> cut_a_few_times(const IndexedMesh& mesh, int cuts)
{
    auto object = std::move(make_back_end()->prepare(mesh).object);
    test::Random random(6);
    for (int i = 0; i < cuts; ++i) {
        CutResult result = cut(std::move(object), *Plane::through(0.6 * random.direction(), random.direction()));
        if (result.object) {
            object = std::move(result.object);
            continue;
        }
        const bool positive = result.positive[0]->triangle_count() > result.negative[0]->triangle_count();
        object = std::move(positive ? result.positive[0] : result.negative[0]);
    }
    return object;
}

TEST(Compaction, KeepsEveryByteOfTheExport)
{
    for (const auto* shapes : {&test::closed_shapes(), &test::open_shapes()})
        for (const auto& shape : *shapes) {
            SCOPED_TRACE(shape.name);
            const auto object = cut_a_few_times(shape.mesh, 3);
            const auto before = referee::bytes_of(object->to_indexed_mesh());
            object->compact();
            EXPECT_EQ(referee::bytes_of(object->to_indexed_mesh()), before);
            EXPECT_EQ(faults(*object), "");
            EXPECT_FALSE(object->wants_compaction());
        }
}

TEST(Compaction, TheCompactedObjectIsCutLikeTheOther)
{
    const auto object = cut_a_few_times(test::closed_shape("asteroid"), 3);
    const auto copy = object->clone();
    copy->compact();
    for (const auto& plane : test::planes_for(object->to_indexed_mesh(), 3, 2)) {
        const CutResult a = cut(object->clone(), plane.plane), b = cut(copy->clone(), plane.plane);
        ASSERT_EQ(a.status, b.status) << plane.name;
        EXPECT_EQ(referee::canonical_surface(a.positive), referee::canonical_surface(b.positive)) << plane.name;
        EXPECT_EQ(referee::canonical_surface(a.negative), referee::canonical_surface(b.negative)) << plane.name;
    }
}

TEST(Compaction, LeavesRelativesAlone)
{
    CutResult result = cut(std::move(make_back_end()->prepare(test::closed_shape("torus")).object),
                           *Plane::through({0.1, 0, 0}, {1, 0.2, 0.1}));
    ASSERT_EQ(result.status, Status::done);
    const auto before = referee::bytes_of(result.negative[0]->to_indexed_mesh());
    result.positive[0]->compact();
    EXPECT_NE(result.positive[0]->draw_view().buffers, result.negative[0]->draw_view().buffers);
    EXPECT_EQ(referee::bytes_of(result.negative[0]->to_indexed_mesh()), before);
    EXPECT_EQ(faults(*result.negative[0]), "");
}

TEST(Compaction, IsWantedWhenMostOfTheBuffersIsDead)
{
    const auto object = cut_a_few_times(test::repaired(shapes::asteroid(20'000, 2)), 40);
    EXPECT_TRUE(object->wants_compaction());
    const std::size_t before = dynamic_cast<const Fragment&>(*object).universe().bytes_reserved();
    object->compact();
    EXPECT_FALSE(object->wants_compaction());
    EXPECT_LT(dynamic_cast<const Fragment&>(*object).universe().bytes_reserved(), before);
}

TEST(Compaction, ACloneOfASmallFragmentIsSmall)
{
    CutResult result = cut(std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(50'000, 2))).object),
                           *Plane::through({0, 0, 0.8}, {0, 0, 1}));
    ASSERT_EQ(result.status, Status::done);
    const Cuttable& small = *result.positive[0];
    const auto copy = small.clone();
    EXPECT_EQ(referee::bytes_of(copy->to_indexed_mesh()), referee::bytes_of(small.to_indexed_mesh()));
    EXPECT_EQ(faults(*copy), "");
    EXPECT_LT(dynamic_cast<const Fragment&>(*copy).universe().bytes_reserved(),
              dynamic_cast<const Fragment&>(small).universe().bytes_reserved() / 2);
}

}  // namespace
}  // namespace kerf::core::halfedge
