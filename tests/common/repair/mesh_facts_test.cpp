#include "common/repair/mesh_facts.h"

#include <gtest/gtest.h>

#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

using namespace small_meshes;

TEST(MeshFacts, OfACube)
{
    const MeshFacts facts = measure(cube({1, 2, 3}, 2));
    EXPECT_EQ(facts.triangles, 12u);
    EXPECT_EQ(facts.vertices, 8u);
    EXPECT_EQ(facts.welded_vertices, 8u);
    EXPECT_TRUE(facts.closed() && facts.manifold() && facts.oriented());
    EXPECT_EQ(facts.shells, 1u);
    EXPECT_EQ(facts.area, 24.0);
    EXPECT_EQ(facts.volume, 8.0);
    EXPECT_EQ(facts.bounds.lo, glm::vec3(1, 2, 3));
    EXPECT_EQ(facts.bounds.hi, glm::vec3(3, 4, 5));
}

TEST(MeshFacts, CountPlacesNotVertices)
{
    const TriangleSoup box = shapes::box({1, 1, 1}, {1, 1, 1});  // normals differ at every corner
    const MeshFacts facts = measure(box);
    EXPECT_EQ(facts.vertices, 24u);
    EXPECT_EQ(facts.welded_vertices, 8u);
    EXPECT_TRUE(facts.closed());
}

TEST(MeshFacts, SeeEdgesAndPointsWhereSolidsTouch)
{
    const MeshFacts at_edge = measure(cube() + cube({1, 1, 0}));
    EXPECT_EQ(at_edge.nonmanifold_edges, 1u);
    EXPECT_EQ(at_edge.nonmanifold_points, 0u);
    EXPECT_EQ(at_edge.shells, 1u);
    EXPECT_TRUE(at_edge.closed());

    const MeshFacts at_point = measure(cube() + cube({1, 1, 1}));
    EXPECT_EQ(at_point.nonmanifold_edges, 0u);
    EXPECT_EQ(at_point.nonmanifold_points, 1u);
    EXPECT_EQ(at_point.shells, 2u);
}

TEST(MeshFacts, CountBoundaryEdgesAndLoops)
{
    TriangleSoup pierced = cube();
    pierced.triangles.erase(pierced.triangles.begin() + 2);
    pierced.triangles.erase(pierced.triangles.begin());
    const MeshFacts facts = measure(pierced);
    EXPECT_EQ(facts.boundary_edges, 6u);
    EXPECT_EQ(facts.boundary_loops, 2u);
    EXPECT_FALSE(facts.closed());
    EXPECT_TRUE(facts.manifold() && facts.oriented());
}

TEST(MeshFacts, CountEdgesWhoseTrianglesDisagree)
{
    TriangleSoup mesh = cube();
    std::swap(mesh.triangles[4][0], mesh.triangles[4][1]);
    EXPECT_EQ(measure(mesh).misoriented_edges, 3u);
    EXPECT_EQ(measure(inside_out(cube())).misoriented_edges, 0u);
    EXPECT_EQ(measure(inside_out(cube())).volume, -1.0);
    EXPECT_EQ(measure(moebius_strip(24)).misoriented_edges, 1u);
}

// No edge has one triangle only, but no way of joining triangles leaves none alone.
TEST(MeshFacts, CallNothingClosedThatCannotBe)
{
    const MeshFacts bottle = measure(klein_bottle(12, 24));
    EXPECT_EQ(bottle.boundary_edges, 0u);
    EXPECT_EQ(bottle.open_edges, 24u);
    EXPECT_FALSE(bottle.closed());

    // A tent in a tetrahedron, up to the ridge: three of its edges are between three triangles.
    TriangleSoup wall = tetrahedron();
    wall.vertices.push_back({{0.25f, 0.25f, 0.25f}, glm::vec3(0.0f), glm::vec2(0.0f)});
    for (const Triangle& t : {Triangle{0, 1, 4}, {1, 2, 4}, {2, 0, 4}}) wall.triangles.push_back(t);
    const MeshFacts facts = measure(wall);
    EXPECT_EQ(facts.boundary_edges, 0u);
    EXPECT_EQ(facts.unbalanced_edges, 3u);
    EXPECT_EQ(facts.open_edges, 3u);

    TriangleSoup turned = cube();
    std::swap(turned.triangles[4][0], turned.triangles[4][1]);
    EXPECT_EQ(measure(turned).unbalanced_edges, 3u);
    EXPECT_TRUE(measure(turned).closed());  // repair() turns it back
}

TEST(MeshFacts, CountFaultyTriangles)
{
    TriangleSoup mesh = tetrahedron();
    mesh.triangles.push_back({1, 2, 1});
    mesh.triangles.push_back({3, 1, 2});  // once more
    mesh.triangles.push_back({3, 2, 1});  // its back is something else
    const MeshFacts facts = measure(mesh);
    EXPECT_EQ(facts.triangles, 7u);
    EXPECT_EQ(facts.degenerate_triangles, 1u);
    EXPECT_EQ(facts.duplicate_triangles, 1u);
    EXPECT_EQ(facts.nonmanifold_edges, 3u);
}

TEST(MeshFacts, OfARepairedMeshGoByPoints)
{
    const MeshFacts facts = measure(*repair(cube() + cube({1, 1, 0})).mesh);
    EXPECT_EQ(facts.welded_vertices, 16u);
    EXPECT_TRUE(facts.closed() && facts.manifold() && facts.oriented());
    EXPECT_EQ(facts.shells, 2u);
    EXPECT_EQ(facts.volume, 2.0);
}

TEST(MeshFacts, OfNothingAreZero)
{
    const MeshFacts facts = measure(TriangleSoup{});
    EXPECT_EQ(facts.triangles + facts.welded_vertices + facts.shells, 0u);
    EXPECT_EQ(facts.volume, 0.0);
}

}  // namespace
}  // namespace kerf::core
