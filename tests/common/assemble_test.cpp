#include "common/assemble.h"

#include <gtest/gtest.h>

#include <limits>

#include "common/half_edge_pairs.h"
#include "common/mesh_facts.h"
#include "common/small_meshes.h"

namespace kerf {
namespace {

using namespace small_meshes;

/// Assembles and checks everything that IndexedMesh promises.
Assembled assembled(TriangleSoup soup)
{
    Assembled result = assemble(std::move(soup));
    EXPECT_EQ(result.error, "");
    EXPECT_EQ(check(result.mesh), "");
    const MeshFacts facts = measure(result.mesh);
    EXPECT_TRUE(facts.manifold());
    EXPECT_TRUE(facts.oriented());
    EXPECT_EQ(facts.degenerate_triangles, 0u);
    EXPECT_EQ(facts.duplicate_triangles, 0u);
    return result;
}

TEST(Assemble, LeavesACleanMeshAlone)
{
    const Assembled result = assembled(tetrahedron());
    EXPECT_TRUE(result.repairs.none()) << result.repairs.describe();
    EXPECT_EQ(result.mesh.point_count, 4u);
    EXPECT_EQ(result.mesh.sources, (Buffer<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_NEAR(measure(result.mesh).volume, 1.0 / 6.0, 1e-15);
}

TEST(Assemble, NamesTheReasonWhenThereIsNoMesh)
{
    EXPECT_EQ(assemble({}).error, "the mesh has no triangles");

    TriangleSoup mesh = tetrahedron();
    mesh.vertices[2].position.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(assemble(mesh).error, "vertex 2 has a coordinate that is not finite");

    mesh = tetrahedron();
    mesh.triangles[3][1] = 4;
    EXPECT_EQ(assemble(mesh).error, "triangle 3 refers to vertex 4, but there are only 4");

    mesh = tetrahedron();
    mesh.triangle_materials = {0, 0, 1, 0};
    EXPECT_EQ(assemble(mesh).error, "triangle 2 refers to material 1, but there are only 1");

    mesh = tetrahedron();
    mesh.triangle_materials = {0, 0, 0};
    EXPECT_EQ(assemble(mesh).error, "there is not one material for each triangle");

    mesh = tetrahedron();
    mesh.streams.push_back({"colour", 3, Buffer<float>(11, 0.0f)});
    EXPECT_EQ(assemble(mesh).error, "stream 'colour' does not have 3 values per vertex");

    EXPECT_EQ(assemble(soup({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}})).error,
              "every triangle of the mesh is degenerate");
}

TEST(Assemble, WeldsPositionsThatDifferInTheSignOfZero)
{
    const TriangleSoup mesh =
        soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, -0.0f}, {-0.0f, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 5}});
    const Assembled result = assembled(mesh);
    EXPECT_EQ(result.mesh.point_count, 4u);
    EXPECT_EQ(measure(result.mesh).shells, 1u);
}

TEST(Assemble, DropsDegenerateAndDuplicateTriangles)
{
    TriangleSoup mesh = tetrahedron();
    mesh.triangles.insert(mesh.triangles.begin(), {1, 1, 2});
    mesh.triangles.push_back({2, 3, 1});  // the same as {1, 2, 3}
    const Assembled result = assembled(mesh);
    EXPECT_EQ(result.repairs.degenerate_triangles, 1u);
    EXPECT_EQ(result.repairs.duplicate_triangles, 1u);
    EXPECT_EQ(result.repairs.describe(), "1 degenerate triangle dropped, 1 duplicate triangle dropped");
    EXPECT_EQ(result.mesh.sources, (Buffer<std::uint32_t>{1, 2, 3, 4}));
}

TEST(Assemble, DividesTwoCubesGluedAtAnEdge)
{
    const Assembled result = assembled(cube({0, 0, 0}) + cube({1, 1, 0}));
    EXPECT_EQ(result.repairs.nonmanifold_edges, 1u);
    EXPECT_EQ(result.repairs.nonmanifold_points, 0u);
    const MeshFacts facts = measure(result.mesh);
    EXPECT_TRUE(facts.closed());
    EXPECT_EQ(facts.shells, 2u);
    EXPECT_EQ(facts.volume, 2.0);
    EXPECT_EQ(result.mesh.point_count, 16u);
}

TEST(Assemble, DividesTwoCubesGluedAtAPoint)
{
    const Assembled result = assembled(cube({0, 0, 0}) + cube({1, 1, 1}));
    EXPECT_EQ(result.repairs.nonmanifold_points, 1u);
    EXPECT_EQ(result.mesh.point_count, 16u);
    EXPECT_TRUE(measure(result.mesh).closed());
}

TEST(Assemble, DividesTwoCubesGluedAtAFace)
{
    const Assembled result = assembled(cube({0, 0, 0}) + cube({1, 0, 0}));
    const MeshFacts facts = measure(result.mesh);
    EXPECT_TRUE(facts.closed());
    EXPECT_EQ(facts.shells, 2u);
    EXPECT_EQ(result.mesh.point_count, 16u);
}

TEST(Assemble, TurnsOverWhatIsInsideOut)
{
    const Assembled result = assembled(inside_out(cube()));
    EXPECT_EQ(result.repairs.flipped_triangles, 12u);
    EXPECT_EQ(measure(result.mesh).volume, 1.0);
}

TEST(Assemble, TurnsOverTheSmallerPartOfAPatchThatDisagrees)
{
    TriangleSoup mesh = cube();
    for (const std::size_t t : {2, 5, 7}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    const Assembled result = assembled(mesh);
    EXPECT_EQ(result.repairs.flipped_triangles, 3u);
    EXPECT_EQ(measure(result.mesh).volume, 1.0);
}

TEST(Assemble, CutsAMoebiusStripOpenAtOneEdge)
{
    const Assembled result = assembled(moebius_strip(24));
    EXPECT_EQ(result.repairs.unorientable_edges, 1u);
    EXPECT_EQ(result.repairs.flipped_triangles, 0u);  // it has a seam already
    EXPECT_EQ(measure(result.mesh).boundary_loops, 1u);
}

TEST(Assemble, CutsAKleinBottleOpenAlongOneRing)
{
    const Assembled result = assembled(klein_bottle(12, 24));
    EXPECT_EQ(result.repairs.unorientable_edges, 12u);
    EXPECT_EQ(result.repairs.nonmanifold_edges, 0u);
    EXPECT_EQ(measure(result.mesh).boundary_edges, 24u);
}

TEST(HalfEdgeTwins, RunAlongTheSamePointsTheOtherWay)
{
    const IndexedMesh mesh = assembled(cube()).mesh;
    const Buffer<std::uint32_t> twins = half_edge_twins(mesh);
    const auto point = [&](std::uint32_t h) { return mesh.points[mesh.triangles[h / 3][h % 3]]; };
    for (std::uint32_t h = 0; h < twins.size(); ++h) {
        ASSERT_NE(twins[h], kNoTwin);
        EXPECT_EQ(twins[twins[h]], h);
        EXPECT_EQ(point(h), point(next_half_edge(twins[h])));
        EXPECT_EQ(point(next_half_edge(h)), point(twins[h]));
    }
}

TEST(HalfEdgeTwins, AreMissingAtTheBoundary)
{
    const IndexedMesh mesh = assembled(moebius_strip(24)).mesh;
    const Buffer<std::uint32_t> twins = half_edge_twins(mesh);
    EXPECT_EQ(static_cast<std::uint64_t>(std::count(twins.begin(), twins.end(), kNoTwin)),
              measure(mesh).boundary_edges);
}

}  // namespace
}  // namespace kerf
