#include "common/repair/repair.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <random>

#include "common/repair/mesh_facts.h"
#include "common/shapes/shapes.h"
#include "support/coinciding_solids.h"
#include "support/small_meshes.h"
#include "support/surface_referee.h"

namespace kerf::core {
namespace {

using namespace small_meshes;

/// What repair() says of a soup is what measure() says, and `open_edges` is the boundary that it leaves.
void expect_facts(const TriangleSoup& soup, const Repaired& result)
{
    const MeshFacts &facts = result.facts, expected = measure(soup);
    EXPECT_EQ(facts.triangles, expected.triangles);
    EXPECT_EQ(facts.vertices, expected.vertices);
    EXPECT_EQ(facts.welded_vertices, expected.welded_vertices);
    EXPECT_EQ(facts.degenerate_triangles, expected.degenerate_triangles);
    EXPECT_EQ(facts.duplicate_triangles, expected.duplicate_triangles);
    EXPECT_EQ(facts.boundary_edges, expected.boundary_edges);
    EXPECT_EQ(facts.boundary_loops, expected.boundary_loops);
    EXPECT_EQ(facts.nonmanifold_edges, expected.nonmanifold_edges);
    EXPECT_EQ(facts.nonmanifold_points, expected.nonmanifold_points);
    EXPECT_EQ(facts.misoriented_edges, expected.misoriented_edges);
    EXPECT_EQ(facts.unbalanced_edges, expected.unbalanced_edges);
    EXPECT_EQ(facts.open_edges, expected.open_edges);
    EXPECT_EQ(facts.shells, expected.shells);
    EXPECT_EQ(facts.shortest_edge, expected.shortest_edge);
    EXPECT_EQ(facts.area, expected.area);
    EXPECT_EQ(facts.volume, expected.volume);
    EXPECT_EQ(facts.bounds.lo, expected.bounds.lo);
    EXPECT_EQ(facts.bounds.hi, expected.bounds.hi);

    const IndexedMesh& mesh = result.mesh;
    EXPECT_EQ(facts.open_edges, surface_referee::judge(mesh).boundary_edges);
    EXPECT_EQ(result.mesh.bounds().lo, mesh.bounds().lo);
    EXPECT_EQ(result.mesh.bounds().hi, mesh.bounds().hi);
    EXPECT_EQ(result.mesh.shortest_edge(), shortest_edge(mesh.vertices, mesh.triangles));
}

/// Repairs, and checks the facts and everything that IndexedMesh promises.
Repaired repaired(const TriangleSoup& soup)
{
    Repaired result = repair(soup);
    EXPECT_EQ(result.error, "");
    expect_facts(soup, result);
    EXPECT_EQ(check(result.mesh), "");
    EXPECT_EQ(surface_referee::judge(result.mesh).fault, "");
    return result;
}

TEST(Repair, LeavesACleanMeshAlone)
{
    const Repaired result = repaired(tetrahedron());
    EXPECT_TRUE(result.repairs.none()) << result.repairs.describe();
    EXPECT_EQ(result.mesh->point_count, 4u);
    EXPECT_EQ(result.mesh->sources, (Buffer<std::uint32_t>{0, 1, 2, 3}));
    EXPECT_NEAR(measure(result.mesh).volume, 1.0 / 6.0, 1e-15);
}

TEST(Repair, NamesTheReasonWhenThereIsNoMesh)
{
    EXPECT_EQ(repair({}).error, "the mesh has no triangles; give it one at least");

    TriangleSoup mesh = tetrahedron();
    mesh.vertices[2].position.y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(repair(mesh).error,
              "vertex 2 has a coordinate that is not finite; give it a number, or take it and its triangles out");

    mesh = tetrahedron();
    mesh.triangles[3][1] = 4;
    EXPECT_EQ(repair(mesh).error, "triangle 3 refers to vertex 4, but there are only 4, counted from 0");

    mesh = tetrahedron();
    mesh.triangle_materials = {0, 0, 1, 0};
    EXPECT_EQ(repair(mesh).error, "triangle 2 refers to material 1, but there are only 1, counted from 0");

    mesh = tetrahedron();
    mesh.triangle_materials = {0, 0, 0};
    EXPECT_EQ(repair(mesh).error, "there is not one material for each triangle; name one for each, or none at all");

    mesh = tetrahedron();
    mesh.streams.push_back({"colour", 3, Buffer<float>(11, 0.0f)});
    EXPECT_EQ(repair(mesh).error, "stream 'colour' does not have 3 values per vertex; complete it or leave it out");

    EXPECT_EQ(repair(soup({{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}, {{0, 1, 2}})).error,
              "every triangle of the mesh is degenerate: two corners of each are at one position; export it again with "
              "positions that differ: with a scale that is not 0, with more digits, or nearer to the origin");
}

TEST(Repair, WeldsPositionsThatDifferInTheSignOfZero)
{
    const TriangleSoup mesh =
        soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, -0.0f}, {-0.0f, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {3, 4, 5}});
    const Repaired result = repaired(mesh);
    EXPECT_EQ(result.mesh->point_count, 4u);
    EXPECT_EQ(measure(result.mesh).shells, 1u);
}

TEST(Repair, DropsDegenerateAndDuplicateTriangles)
{
    TriangleSoup mesh = tetrahedron();
    mesh.triangles.insert(mesh.triangles.begin(), {1, 1, 2});
    mesh.triangles.push_back({2, 3, 1});  // the same as {1, 2, 3}
    const Repaired result = repaired(mesh);
    EXPECT_EQ(result.repairs.degenerate_triangles, 1u);
    EXPECT_EQ(result.repairs.duplicate_triangles, 1u);
    EXPECT_EQ(result.repairs.describe(), "1 degenerate triangle dropped, 1 duplicate triangle dropped");
    EXPECT_EQ(result.mesh->sources, (Buffer<std::uint32_t>{1, 2, 3, 4}));
}

// Dropping a triangle of this mesh because it is there twice opens one of the two solids.
TEST(Repair, KeepsATriangleTwiceThatTwoSolidsHaveInCommon)
{
    const Repaired result =
        repaired(soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2f, 0.2f, 1}, {0.3f, 0.3f, 2}},
                      {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}}));
    EXPECT_EQ(result.repairs.duplicate_triangles, 0u);
    EXPECT_EQ(result.repairs.coinciding_triangles, 1u);
    EXPECT_EQ(result.repairs.describe(),
              "1 triangle that lies on another kept, 3 edges with more than two triangles divided");
    const MeshFacts facts = measure(result.mesh);
    EXPECT_TRUE(facts.closed());
    EXPECT_EQ(facts.shells, 2u);
    EXPECT_EQ(result.mesh->point_count, 8u);
    EXPECT_NEAR(facts.volume, 0.5, 1e-7);
}

TEST(Repair, DropsAWholeShellThatIsThereTwice)
{
    const Repaired result = repaired(cube() + cube() + cube({5, 0, 0}));
    EXPECT_EQ(result.repairs.duplicate_triangles, 12u);
    EXPECT_EQ(result.repairs.coinciding_triangles, 0u);
    EXPECT_EQ(measure(result.mesh).volume, 2.0);
}

// Two triangles of an open edge are no neighbours where they are one and the same, twice.
TEST(Repair, LeavesCoincidingTrianglesOpenWhereTheyWere)
{
    TriangleSoup mesh = soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2f, 0.2f, 1}, {0.3f, 0.3f, 2}},
                             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 2, 1}, {0, 1, 4}, {1, 2, 4}});
    const Repaired result = repaired(mesh);
    EXPECT_EQ(result.repairs.coinciding_triangles, 1u);
    EXPECT_EQ(result.repairs.flipped_triangles, 0u);
    EXPECT_EQ(measure(result.mesh).boundary_edges, 6u);
    EXPECT_EQ(measure(mesh).open_edges, 6u);
}

TEST(Repair, DividesTwoCubesGluedAtAnEdge)
{
    const Repaired result = repaired(cube({0, 0, 0}) + cube({1, 1, 0}));
    EXPECT_EQ(result.repairs.nonmanifold_edges, 1u);
    EXPECT_EQ(result.repairs.nonmanifold_points, 0u);
    const MeshFacts facts = measure(result.mesh);
    EXPECT_TRUE(facts.closed());
    EXPECT_EQ(facts.shells, 2u);
    EXPECT_EQ(facts.volume, 2.0);
    EXPECT_EQ(result.mesh->point_count, 16u);
}

TEST(Repair, DividesGluedCubesWhicheverWayTheyAreTurned)
{
    const Repaired one_inverted = repaired(cube({0, 0, 0}) + inside_out(cube({1, 1, 0})));
    EXPECT_EQ(one_inverted.repairs.flipped_triangles, 12u);
    EXPECT_EQ(measure(one_inverted.mesh).volume, 2.0);

    TriangleSoup mixed = cube({0, 0, 0}) + cube({1, 1, 0});
    for (const std::size_t t : {1, 6, 11, 14, 15, 20}) std::swap(mixed.triangles[t][1], mixed.triangles[t][2]);
    const Repaired result = repaired(mixed);
    EXPECT_EQ(result.repairs.flipped_triangles, 6u);
    EXPECT_EQ(measure(result.mesh).volume, 2.0);
}

TEST(Repair, OpensAWallThatEndsAtAnotherSurface)
{
    // A fin on a cube's edge: one triangle finds no partner there.
    TriangleSoup fin = soup({{0, 0, 0}, {1, 0, 0}, {0, -1, -1}}, {{0, 1, 2}});
    const Repaired result = repaired(cube() + fin);
    EXPECT_EQ(result.repairs.nonmanifold_edges, 1u);
    EXPECT_EQ(measure(result.mesh).boundary_edges, 3u);
    EXPECT_EQ(measure(result.mesh).shells, 2u);
}

TEST(Repair, KeepsBothSidesOfASheet)
{
    const TriangleSoup sheet =
        grid(3, 4, [](std::uint32_t i, std::uint32_t j) { return glm::vec3(float(i), float(j), 0); });
    const Repaired result = repaired(sheet + inside_out(sheet));
    // Front and back meet at the rim: a flat pillow. Two corner triangles come off, because the side opposite to the
    // corner runs from rim to rim: front and back would pass there between the same two points.
    EXPECT_EQ(measure(result.mesh).shells, 3u);
    EXPECT_TRUE(measure(result.mesh).closed());
    EXPECT_EQ(result.mesh->triangles.size(), 2 * sheet.triangles.size());
}

TEST(Repair, DividesTwoCubesGluedAtAPoint)
{
    const Repaired result = repaired(cube({0, 0, 0}) + cube({1, 1, 1}));
    EXPECT_EQ(result.repairs.nonmanifold_points, 1u);
    EXPECT_EQ(result.mesh->point_count, 16u);
    EXPECT_TRUE(measure(result.mesh).closed());
}

TEST(Repair, DividesTwoCubesGluedAtAFace)
{
    const Repaired result = repaired(cube({0, 0, 0}) + cube({1, 0, 0}));
    const MeshFacts facts = measure(result.mesh);
    EXPECT_TRUE(facts.closed());
    EXPECT_EQ(facts.shells, 2u);
    EXPECT_EQ(result.mesh->point_count, 16u);
}

TEST(Repair, TurnsOverWhatIsInsideOut)
{
    const Repaired result = repaired(inside_out(cube()));
    EXPECT_EQ(result.repairs.flipped_triangles, 12u);
    EXPECT_EQ(measure(result.mesh).volume, 1.0);
}

TEST(Repair, TurnsOverTheSmallerPartOfAPatchThatDisagrees)
{
    TriangleSoup mesh = cube();
    for (const std::size_t t : {2, 5, 7}) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    const Repaired result = repaired(mesh);
    EXPECT_EQ(result.repairs.flipped_triangles, 3u);
    EXPECT_EQ(measure(result.mesh).volume, 1.0);
}

TEST(Repair, CutsAMoebiusStripOpenAtOneEdge)
{
    const Repaired result = repaired(moebius_strip(24));
    EXPECT_EQ(result.repairs.unorientable_edges, 1u);
    EXPECT_EQ(result.repairs.flipped_triangles, 0u);  // it has a seam already
    EXPECT_EQ(measure(result.mesh).boundary_loops, 1u);
}

TEST(Repair, CutsAKleinBottleOpenAlongOneRing)
{
    const Repaired result = repaired(klein_bottle(12, 24));
    EXPECT_EQ(result.repairs.unorientable_edges, 12u);
    EXPECT_EQ(result.repairs.nonmanifold_edges, 0u);
    EXPECT_EQ(measure(result.mesh).boundary_edges, 24u);
}

TEST(Repair, NamesEveryMaterialAndHasOne)
{
    TriangleSoup mesh = tetrahedron();
    EXPECT_EQ(repaired(mesh).mesh->materials.at(0).name, "surface");
    mesh.materials.resize(2);
    mesh.materials[0].name = "bark";
    const Repaired result = repaired(mesh);
    ASSERT_EQ(result.mesh->materials.size(), 2u);
    EXPECT_EQ(result.mesh->materials[0].name, "bark");
    EXPECT_EQ(result.mesh->materials[1].name, "material 1");
}

TEST(Repair, GroupsTrianglesByMaterialThenSolidInOtherwiseUnchangedOrder)
{
    TriangleSoup mesh = cube({5, 0, 0}) + cube();
    mesh.materials.resize(2);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.triangle_materials.push_back(t % 2);
    const Repaired result = repaired(mesh);
    ASSERT_EQ(result.mesh->groups.size(), 4u);
    for (std::uint32_t g = 0; g < 4; ++g) {
        EXPECT_EQ(result.mesh->groups[g].material, g / 2);
        EXPECT_EQ(result.mesh->groups[g].solid, g % 2);
        EXPECT_EQ(result.mesh->groups[g].count, 6u);
        for (std::uint32_t i = 0; i < 6; ++i)
            EXPECT_EQ(result.mesh->sources[result.mesh->groups[g].first + i], 12 * (g % 2) + 2 * i + g / 2);
    }
}

TEST(Repair, DropsVerticesThatNobodyUsesAndNumbersTheOthersByFirstUse)
{
    TriangleSoup mesh = tetrahedron();
    mesh.vertices.insert(mesh.vertices.begin(), {{9, 9, 9}, {0, 0, 1}, {0, 0}});
    for (Triangle& triangle : mesh.triangles)
        for (std::uint32_t& v : triangle) ++v;
    const Repaired result = repaired(mesh);
    std::uint32_t next_point = 0, next_vertex = 0;
    for (const Triangle& triangle : result.mesh->triangles)
        for (const std::uint32_t v : triangle) {
            ASSERT_LE(v, next_vertex);
            next_vertex += v == next_vertex;
            ASSERT_LE(result.mesh->points[v], next_point);
            next_point += result.mesh->points[v] == next_point;
        }
    EXPECT_LT(result.mesh->bounds().hi.x, 2.0f);
}

TEST(Repair, TurnsNormalsOfWhatItTurnsOverAndReplacesLostOnes)
{
    TriangleSoup mesh = shapes::icosphere(1.0f, 2);
    mesh.vertices[3].normal = glm::vec3(0.0f);
    mesh.vertices[5].normal *= 3.0f;
    for (const bool normals_too : {false, true}) {
        TriangleSoup turned = inside_out(mesh);
        if (normals_too)
            for (Vertex& v : turned.vertices) v.normal = -v.normal;
        const Repaired result = repaired(turned);
        EXPECT_EQ(result.repairs.flipped_triangles, mesh.triangles.size());
        for (const Vertex& v : result.mesh->vertices) {
            EXPECT_NEAR(glm::length(v.normal), 1.0f, 1e-5f);
            EXPECT_GT(glm::dot(v.normal, v.position), 0.9f);
        }
    }
}

/// What every repaired mesh keeps of its soup, triangle by triangle.
void expect_faithful(const TriangleSoup& soup, const Repaired& result)
{
    const IndexedMesh& mesh = result.mesh;
    const Repairs& repairs = result.repairs;
    EXPECT_EQ(check(mesh), "");
    EXPECT_EQ(surface_referee::judge(mesh).fault, "");
    EXPECT_EQ(mesh.triangles.size() + repairs.degenerate_triangles + repairs.duplicate_triangles,
              soup.triangles.size());
    std::uint64_t flipped = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Triangle& from = soup.triangles[mesh.sources[t]];
        std::array<Vertex, 3> expected{soup.vertices[from[0]], soup.vertices[from[1]], soup.vertices[from[2]]};
        const auto position = [&](std::size_t i) { return mesh.vertices[mesh.triangles[t][i]].position; };
        if (position(1) != expected[1].position) {
            ++flipped;
            std::swap(expected[1], expected[2]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_EQ(position(i), expected[i].position);
            EXPECT_EQ(mesh.vertices[mesh.triangles[t][i]].uv, expected[i].uv);
        }
    }
    EXPECT_EQ(repairs.flipped_triangles, flipped);
}

bool same_bytes(const IndexedMesh& a, const IndexedMesh& b)
{
    const auto same = [](const auto& p, const auto& q) {
        return p.size() == q.size() && (p.empty() || std::memcmp(p.data(), q.data(), p.size() * sizeof(p[0])) == 0);
    };
    return same(a.vertices, b.vertices) && same(a.points, b.points) && same(a.triangles, b.triangles) &&
           same(a.sources, b.sources) && a.groups.size() == b.groups.size();
}

// Twenty-seven places and many triangles: nearly every edge and point is non-manifold.
RC_GTEST_PROP(Repair, KeepsItsPromisesForAnyTriangles, ())
{
    const auto number = [](int n) { return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, n)); };
    TriangleSoup soup;
    soup.has_normals = number(2) == 1;
    const int side = 2 + number(3), count = 1 + number(number(2) ? 12 : 150);
    for (int i = 0; i < 60; ++i)
        soup.vertices.push_back({glm::vec3(float(number(side)), float(number(side)), float(number(side))),
                                 glm::vec3(0, 0, 1), glm::vec2(float(number(2)), 0.0f)});
    for (int i = 0; i < count; ++i)
        soup.triangles.push_back({static_cast<std::uint32_t>(number(60)), static_cast<std::uint32_t>(number(60)),
                                  static_cast<std::uint32_t>(number(60))});
    const Repaired result = repair(soup);
    if (!result.error.empty()) {
        RC_ASSERT(result.error.starts_with("every triangle of the mesh is degenerate: "));
        return;
    }
    expect_faithful(soup, result);
    expect_facts(soup, result);
    RC_ASSERT(same_bytes(result.mesh, *repair(soup).mesh));
}

TEST(Repair, KeepsClosedWhatIsClosed)
{
    std::uint64_t dropped = 0, kept = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const TriangleSoup mesh = solids_with_common_triangles(random);
        const MeshFacts facts = measure(mesh);
        ASSERT_EQ(facts.unbalanced_edges, 0u);
        ASSERT_TRUE(facts.closed());
        const Repaired result = repair(mesh);
        expect_faithful(mesh, result);
        ASSERT_EQ(surface_referee::judge(result.mesh).boundary_edges, 0u);
        dropped += result.repairs.duplicate_triangles;
        kept += result.repairs.coinciding_triangles;
    }
    EXPECT_GT(dropped, 2000u);
    EXPECT_GT(kept, 2000u);
}

// Balance was taken before triangles were turned back: the copy lost all but the one that was turned over, or the base
// that both solids need was dropped.
TEST(Repair, DropsAShellThatIsThereTwiceWhicheverTrianglesAreTurnedOver)
{
    for (std::size_t turned = 0; turned <= 12; ++turned) {
        SCOPED_TRACE(std::to_string(turned) + " turned over");
        TriangleSoup mesh = cube() + cube();
        for (std::size_t t = 12; t < 12 + turned; ++t) std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
        EXPECT_TRUE(measure(mesh).closed());
        const Repaired result = repaired(mesh);
        const MeshFacts facts = measure(result.mesh);
        EXPECT_EQ(facts.boundary_edges, 0u);
        // With most of it turned over it is a copy inside out.
        EXPECT_EQ(facts.shells, turned <= 6 ? 1u : 2u);
        EXPECT_EQ(result.repairs.duplicate_triangles, turned <= 6 ? 12u : 0u);
    }
}

TEST(Repair, ClosesSolidsOnOneBaseWhicheverSidesAreTurnedOver)
{
    for (const bool is_base_turned : {false, true})
        for (std::size_t turned = 0; turned < 64; ++turned) {
            SCOPED_TRACE((is_base_turned ? "base and back, " : "bases, ") + std::to_string(turned));
            TriangleSoup mesh =
                soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.2f, 0.2f, 1}, {0.3f, 0.3f, 2}},
                     {{0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}, {0, 2, 1}, {0, 2, 1}});
            for (std::size_t t = 0; t < 6; ++t)
                if (turned >> t & 1) std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
            if (is_base_turned) std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
            EXPECT_EQ(measure(mesh).open_edges, 0u);
            const Repaired result = repaired(mesh);
            EXPECT_EQ(measure(result.mesh).boundary_edges, 0u);
            EXPECT_EQ(result.repairs.duplicate_triangles, 0u);
            EXPECT_EQ(measure(result.mesh).shells, 2u);
        }
}

TEST(Repair, ClosesWhatIsClosedButForTrianglesThatAreTurnedOver)
{
    std::uint64_t closed = 0, flipped = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        TriangleSoup mesh = solids_with_common_triangles(random);
        if (!turn_some_over(mesh, random)) continue;
        const Repaired result = repair(mesh);
        expect_faithful(mesh, result);
        ASSERT_EQ(surface_referee::judge(result.mesh).boundary_edges, 0u);
        ASSERT_TRUE(measure(mesh).closed());
        ++closed;
        flipped += result.repairs.flipped_triangles;
    }
    EXPECT_GT(closed, 1500u);
    EXPECT_GT(flipped, 1500u);
}

// A triangle and its back are closed: nothing may open them for the sake of an edge elsewhere.
TEST(Repair, DoesNotTurnATriangleOffItsBack)
{
    const Repaired result = repaired(
        soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 1}, {0, -1, -1}}, {{0, 1, 2}, {1, 0, 2}, {0, 1, 3}, {0, 1, 4}}));
    EXPECT_EQ(result.repairs.flipped_triangles, 1u);
    EXPECT_EQ(measure(result.mesh).boundary_edges, 4u);
}

// One of two triangles in one place is turned over for the sake of edges where more meet: then it is the other's back.
TEST(Repair, LinksARepeatThatIsTurnedOverToItsCopyAllAround)
{
    const TriangleSoup mesh = soup({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 0}},
                                   {{1, 2, 0}, {4, 0, 1}, {2, 0, 1}, {2, 1, 4}, {1, 3, 2}});
    const Repaired result = repaired(mesh);
    EXPECT_EQ(measure(mesh).open_edges, 5u);
    EXPECT_EQ(surface_referee::judge(result.mesh).boundary_edges, 5u);
}

// Closed with some triangles gone, turned over, or once more: kerf info must not call closed what comes out open.
TEST(Repair, ComesOutClosedWhereTheFactsSaySoAndNowhereElse)
{
    std::size_t closed = 0, open = 0;
    for (std::uint32_t seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        TriangleSoup mesh = solids_with_common_triangles(random);
        for (auto i = random() % 4; i > 0; --i) {
            const std::size_t t = random() % mesh.triangles.size();
            const Triangle triangle = mesh.triangles[t];
            switch (random() % 3) {
                case 0:
                    mesh.triangles[t] = {triangle[0], triangle[2], triangle[1]};
                    break;
                case 1:
                    mesh.triangles.push_back(triangle);
                    break;
                default:
                    mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(t));
            }
        }
        const MeshFacts facts = measure(mesh);
        const Repaired result = repair(mesh);
        const std::uint64_t boundary = surface_referee::judge(result.mesh).boundary_edges;
        ASSERT_EQ(facts.open_edges, boundary);
        ASSERT_EQ(facts.closed(), boundary == 0);
        (boundary == 0 ? closed : open) += 1;
    }
    EXPECT_GT(closed, 300u);
    EXPECT_GT(open, 300u);
}

/// The surface of a set of unit cubes on a lattice: where cubes meet in an edge or a point only, so does the surface.
TriangleSoup voxels(const std::vector<glm::ivec3>& cells)
{
    const auto filled = [&](const glm::ivec3& cell) {
        return std::find(cells.begin(), cells.end(), cell) != cells.end();
    };
    TriangleSoup mesh;
    mesh.has_normals = false;
    for (const glm::ivec3& cell : cells)
        for (int axis = 0; axis < 3; ++axis)
            for (const int up : {0, 1}) {
                glm::ivec3 step(0), u(0), v(0);
                step[axis] = up ? 1 : -1;
                if (filled(cell + step)) continue;
                u[(axis + 1) % 3] = 1;
                v[(axis + 2) % 3] = 1;
                if (!up) std::swap(u, v);
                const glm::ivec3 corner = cell + (up ? step : glm::ivec3(0));
                const auto n = static_cast<std::uint32_t>(mesh.vertices.size());
                for (const glm::ivec3& p : {corner, corner + u, corner + u + v, corner + v})
                    mesh.vertices.push_back({glm::vec3(p), glm::vec3(0.0f), glm::vec2(0.0f)});
                mesh.triangles.push_back({n, n + 1, n + 2});
                mesh.triangles.push_back({n, n + 2, n + 3});
            }
    return mesh;
}

RC_GTEST_PROP(Repair, MakesSolidsOfVoxelsThatTouchInEdgesAndPoints, ())
{
    const int side = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(2, 5));
    const int share = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(1, 10));
    std::vector<glm::ivec3> cells{{0, 0, 0}};
    for (int i = 1; i < side * side * side; ++i)
        if (*rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, 10)) < share)
            cells.push_back({i % side, i / side % side, i / side / side});
    const TriangleSoup soup = voxels(cells);
    const Repaired result = repair(soup);
    RC_ASSERT(result.error == "");
    expect_faithful(soup, result);
    RC_ASSERT(surface_referee::judge(result.mesh).boundary_edges == 0u);
    RC_ASSERT(result.repairs.flipped_triangles == 0u);
    RC_ASSERT(std::abs(measure(result.mesh).volume - double(cells.size())) < 1e-9);
}

RC_GTEST_PROP(Repair, OrientsAnySurfaceWhoseTrianglesWereTurnedAtRandom, ())
{
    TriangleSoup soup = shapes::torus(2.0f, 0.5f, 16, 9);
    soup = std::move(soup) + inside_out(shapes::torus(2.0f, 0.25f, 16, 9));
    soup.has_normals = false;
    const double volume = measure(soup).volume;
    std::mt19937 random(*rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0u, 1000000u))));
    for (Triangle& triangle : soup.triangles)
        if (random() % 2 == 0) std::swap(triangle[1], triangle[2]);
    const Repaired result = repair(soup);
    expect_faithful(soup, result);
    const MeshFacts facts = measure(result.mesh);
    RC_ASSERT(facts.closed());
    RC_ASSERT(result.repairs.unorientable_edges == 0u);
    // The inner one comes out either way: as a cavity, or as a solid within the other.
    const double inner = volume * (0.25 * 0.25) / (0.5 * 0.5 - 0.25 * 0.25);
    RC_ASSERT(std::min(std::abs(facts.volume - volume), std::abs(facts.volume - volume - 2 * inner)) < 1e-5 * volume);
}

}  // namespace
}  // namespace kerf::core
