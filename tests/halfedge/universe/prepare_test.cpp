// Preparing keeps the mesh and stays within its budget of memory.

#include <gtest/gtest.h>

#include "common/shapes/shapes.h"
#include "halfedge/fragment.h"
#include "halfedge/halfedge.h"
#include "support/fixtures.h"
#include "support/referee.h"

namespace kerf::core::halfedge {
namespace {

TEST(Prepare, KeepsEveryTriangleWithItsAttributes)
{
    for (const auto* shapes : {&test::closed_shapes(), &test::open_shapes()})
        for (const auto& shape : *shapes) {
            const auto object = std::move(make_back_end()->prepare(shape.mesh).object);
            const IndexedMesh copy = object->to_indexed_mesh();
            EXPECT_EQ(check(copy), "");
            EXPECT_EQ(referee::canonical_surface(copy), referee::canonical_surface(shape.mesh)) << shape.name;
            EXPECT_EQ(copy.point_count, shape.mesh.point_count) << shape.name;
            EXPECT_EQ(referee::open_edges(copy), referee::open_edges(shape.mesh)) << shape.name;
        }
}

TEST(Prepare, HoldsAtMostTheStatedMemory)
{
    constexpr double kBytesPerTriangle = 250;
    const auto object = std::move(make_back_end()->prepare(test::repaired(shapes::asteroid(100'000, 1))).object);
    const auto& fragment = dynamic_cast<const Fragment&>(*object);
    EXPECT_LE(double(fragment.universe().bytes_reserved()), kBytesPerTriangle * double(object->triangle_count()));
}

TEST(Prepare, TheOrderOfTheInputMattersLittleToTheCut)
{
    const TriangleSoup soup = shapes::asteroid(20'000, 1);
    const auto coherent = std::move(make_back_end()->prepare(test::repaired(soup)).object);
    const auto shuffled = std::move(make_back_end()->prepare(test::repaired(shapes::shuffled(soup, 5))).object);
    const Plane plane = *Plane::through({0.1, 0, 0}, {1, 1, 1});
    const CutResult a = cut(coherent->clone(), plane), b = cut(shuffled->clone(), plane);
    EXPECT_EQ(a.statistics.crossing_triangles, b.statistics.crossing_triangles);
    EXPECT_NEAR(double(a.statistics.nodes_visited), double(b.statistics.nodes_visited),
                0.1 * double(a.statistics.nodes_visited));
}

}  // namespace
}  // namespace kerf::core::halfedge
