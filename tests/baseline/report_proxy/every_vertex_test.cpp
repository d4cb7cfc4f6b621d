#include "baseline/report_proxy/every_vertex.h"

#include <gtest/gtest.h>

#include "baseline/baseline.h"
#include "common/shapes/shapes.h"
#include "support/fixtures.h"

namespace kerf::core::baseline {
namespace {

TEST(EveryVertex, KeepsAllOfThemInOrder)
{
    const TriangleSoup soup = shapes::cylinder(1.0f, 2.0f, 12);
    const CollisionProxy proxy = every_vertex(soup.vertices);
    EXPECT_EQ(proxy.kind, ProxyKind::points);
    ASSERT_EQ(proxy.points.size(), soup.vertices.size());
    for (std::size_t i = 0; i < proxy.points.size(); ++i) EXPECT_EQ(proxy.points[i], soup.vertices[i].position);
    EXPECT_TRUE(proxy.faces.empty());
}

TEST(EveryVertex, HasTheBoxOfItsVertices)
{
    const IndexedMesh& mesh = test::closed_shape("asteroid");
    const CollisionProxy proxy = every_vertex(mesh.vertices);
    EXPECT_EQ(proxy.box.lo, mesh.bounds().lo);
    EXPECT_EQ(proxy.box.hi, mesh.bounds().hi);
    EXPECT_TRUE(every_vertex(std::span<const Vertex>{}).box.empty());
    EXPECT_TRUE(every_vertex(std::span<const Vertex>{}).points.empty());
}

TEST(EveryVertex, OfAnObjectIsThatOfItsVertices)
{
    const auto object = make_back_end()->prepare(test::closed_shape("torus")).object;
    std::vector<Vertex> room;
    EXPECT_EQ(every_vertex(*object).points, every_vertex(object->used_vertices(room)).points);
}

}  // namespace
}  // namespace kerf::core::baseline
