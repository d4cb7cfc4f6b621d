#include "common/repair/solids.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "common/repair/mesh_facts.h"
#include "common/repair/repair.h"
#include "common/shapes/shapes.h"
#include "support/small_meshes.h"

namespace kerf::core {
namespace {

using namespace small_meshes;

/// Solid of each soup triangle that was kept.
std::map<std::uint32_t, std::uint32_t> solids_by_source(const IndexedMesh& mesh)
{
    std::map<std::uint32_t, std::uint32_t> solids;
    for (const TriangleGroup& group : mesh.groups)
        for (std::uint32_t t = group.first; t < group.first + group.count; ++t) solids[mesh.sources[t]] = group.solid;
    return solids;
}

/// Solid of each of the shells that a soup was put together from, each of `size` triangles.
std::vector<std::uint32_t> solids_of_shells(const Repaired& repaired, std::size_t size, std::size_t count)
{
    const auto by_source = solids_by_source(repaired.mesh);
    std::vector<std::uint32_t> solids;
    for (std::size_t i = 0; i < count; ++i) solids.push_back(by_source.at(static_cast<std::uint32_t>(i * size)));
    return solids;
}

TriangleSoup sphere(float radius, const glm::vec3& centre = glm::vec3(0.0f))
{
    TriangleSoup mesh = shapes::icosphere(radius, 4);
    for (Vertex& v : mesh.vertices) v.position += centre;
    return mesh;
}
constexpr std::size_t kSphereTriangles = std::size_t{20} * 4 * 4;

TEST(Solids, AnOuterShellAndItsCavityAreOneSolid)
{
    const Repaired result = repair(shapes::sphere_in_sphere(2.0f, 1.0f, 4));
    ASSERT_EQ(result.error, "");
    EXPECT_TRUE(result.repairs.none()) << result.repairs.describe();
    ASSERT_EQ(result.mesh->groups.size(), 1u);
}

TEST(Solids, ABallInACavityIsASolidOfItsOwn)
{
    const Repaired result = repair(sphere(1) + inside_out(sphere(2)) + sphere(3) + inside_out(sphere(4)) + sphere(5));
    EXPECT_TRUE(result.repairs.none()) << result.repairs.describe();
    EXPECT_EQ(solids_of_shells(result, kSphereTriangles, 5), (std::vector<std::uint32_t>{0, 1, 1, 2, 2}));
}

TEST(Solids, WhatIsInsideOutIsTurnedOverWithEverythingInIt)
{
    const Repaired result = repair(inside_out(sphere(1)) + sphere(2) + inside_out(sphere(3)) + sphere(1, {9, 0, 0}));
    EXPECT_EQ(result.repairs.flipped_triangles, 3 * kSphereTriangles);
    EXPECT_EQ(solids_of_shells(result, kSphereTriangles, 4), (std::vector<std::uint32_t>{0, 1, 1, 2}));
    EXPECT_GT(measure(result.mesh).volume, 0.0);
}

TEST(Solids, ABallInTheHoleOfATorusIsNotInTheTorus)
{
    TriangleSoup ball = inside_out(shapes::icosphere(0.5f, 2));
    const Repaired result = repair(shapes::torus(2.0f, 0.5f, 24, 12) + ball);
    EXPECT_EQ(result.repairs.flipped_triangles, ball.triangles.size());
    EXPECT_EQ(result.mesh->groups.size(), 2u);
}

TEST(Solids, ACavityMayTouchTheWall)
{
    // In a corner of the outer cube: a vertex, three edges and three faces are shared.
    for (const glm::vec3 corner : {glm::vec3(0, 0, 0), glm::vec3(0, 1, 1), glm::vec3(0, 0, 1), glm::vec3(2, 2, 2)}) {
        const Repaired result = repair(cube({0, 0, 0}, 3) + inside_out(cube(corner, 1)));
        ASSERT_EQ(result.error, "");
        EXPECT_EQ(result.repairs.flipped_triangles, 0u);
        EXPECT_EQ(result.mesh->groups.size(), 1u);
        const MeshFacts facts = measure(result.mesh);
        EXPECT_TRUE(facts.closed() && facts.manifold() && facts.oriented());
        EXPECT_EQ(facts.volume, 26.0);
    }
}

TEST(Solids, AShellWithoutVolumeBelongsToTheSolidAroundIt)
{
    // A triangle and its back; not on a lattice, so that the volume is 0 but for rounding.
    const TriangleSoup flat =
        soup({{0.21f, 0.22f, 0.53f}, {0.81f, 0.23f, 0.57f}, {0.24f, 0.83f, 0.51f}}, {{0, 1, 2}, {1, 0, 2}});
    EXPECT_EQ(repair(cube() + flat).mesh->groups.size(), 1u);
    EXPECT_EQ(repair(cube() + flat + inside_out(flat)).mesh->groups.size(), 1u);
    EXPECT_EQ(repair(cube({5, 0, 0}) + flat).mesh->groups.size(), 2u);
}

TEST(Solids, OverlappingSolidsStayTwo)
{
    const Repaired result = repair(cube({0, 0, 0}) + cube({0.5f, 0.5f, 0.5f}));
    EXPECT_TRUE(result.repairs.none());
    EXPECT_EQ(result.mesh->groups.size(), 2u);
}

TEST(Solids, AnOpenShellIsASolidOfItsOwnAndKeepsItsOrientation)
{
    TriangleSoup lid = soup({{0.2f, 0.2f, 0.5f}, {0.8f, 0.2f, 0.5f}, {0.2f, 0.8f, 0.5f}}, {{0, 2, 1}});
    const Repaired result = repair(cube() + lid);
    EXPECT_TRUE(result.repairs.none()) << result.repairs.describe();
    EXPECT_EQ(result.mesh->groups.size(), 2u);
}

TEST(Solids, AShellWithASmallHoleCanBeInsideOut)
{
    TriangleSoup ball = inside_out(sphere(1));
    ball.triangles.resize(ball.triangles.size() - 2);
    EXPECT_EQ(repair(ball).repairs.flipped_triangles, ball.triangles.size());

    TriangleSoup bowl = inside_out(sphere(1));
    std::erase_if(bowl.triangles, [&](const Triangle& t) { return bowl.vertices[t[0]].position.z > 0.0f; });
    EXPECT_EQ(repair(bowl).repairs.flipped_triangles, 0u);
}

/// Cubes in cubes in cubes, at random, with random orientations. The generator knows who is in whom.
struct NestedCubes
{
    TriangleSoup soup;
    std::vector<std::uint32_t> parent;  ///< kNone for outermost ones
    std::vector<bool> inverted;

    static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

    explicit NestedCubes(std::uint32_t seed) : random_(seed)
    {
        soup.has_normals = false;
        fill({0, 0, 0}, 1024.0f, kNone, 0);
        // Neighbours in the soup need not be neighbours in space.
        std::vector<std::uint32_t> order(parent.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        std::shuffle(order.begin(), order.end(), random_);
        const std::vector<Triangle> triangles(soup.triangles.begin(), soup.triangles.end());
        const auto old_parent = parent;
        const auto old_inverted = inverted;
        std::vector<std::uint32_t> place(order.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) place[order[i]] = i;
        for (std::uint32_t i = 0; i < order.size(); ++i) {
            std::copy_n(&triangles[12 * std::size_t{order[i]}], 12, &soup.triangles[12 * std::size_t{i}]);
            parent[i] = old_parent[order[i]] == kNone ? kNone : place[old_parent[order[i]]];
            inverted[i] = old_inverted[order[i]];
        }
    }

    /// What repair() should find: the shells that are turned over, and for each shell the one that owns its solid.
    bool turned_over(std::uint32_t shell) const
    {
        while (parent[shell] != kNone) shell = parent[shell];
        return inverted[shell];
    }
    std::uint32_t owner(std::uint32_t shell) const
    {
        while (inverted[shell] != turned_over(shell)) shell = parent[shell];
        return shell;
    }

private:
    std::uint32_t below(std::uint32_t n) { return std::uniform_int_distribution<std::uint32_t>(0, n - 1)(random_); }

    void fill(const glm::vec3& corner, float size, std::uint32_t inside, int depth)
    {
        // Eight slots, some of them with a cube that leaves a margin, sometimes none at the bottom.
        for (int slot = 0; slot < 8; ++slot) {
            if (below(3) != 0 || depth > 5) continue;
            const float half = size / 2, margin = half / 16 * static_cast<float>(1 + below(3));
            const glm::vec3 place =
                corner + half * glm::vec3(float(slot & 1), float(slot >> 1 & 1), float(slot >> 2 & 1)) + margin;
            const bool invert = below(2) == 1;
            TriangleSoup one = cube(place, half - 2 * margin);
            const auto index = static_cast<std::uint32_t>(parent.size());
            soup = std::move(soup) + (invert ? inside_out(one) : one);
            parent.push_back(inside);
            inverted.push_back(invert);
            fill(place, half - 2 * margin, index, depth + 1);
        }
    }

    std::mt19937 random_;
};

RC_GTEST_PROP(Solids, AreFoundAmongCubesInCubesInCubes, ())
{
    const NestedCubes cubes(*rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0u, 1000000u))));
    RC_PRE(!cubes.parent.empty());
    const Repaired result = repair(cubes.soup);
    RC_ASSERT(result.error == "");

    std::uint64_t turned_over = 0;
    std::map<std::uint32_t, std::uint32_t> solid_of_owner;
    const std::vector<std::uint32_t> solids = solids_of_shells(result, 12, cubes.parent.size());
    for (std::uint32_t i = 0; i < cubes.parent.size(); ++i) {
        turned_over += cubes.turned_over(i) ? 12 : 0;
        const auto [place, is_new] = solid_of_owner.try_emplace(cubes.owner(i), solids[i]);
        RC_ASSERT(place->second == solids[i]);
        if (is_new) RC_ASSERT(solids[i] == solid_of_owner.size() - 1);  // dense, in the order of first shells
    }
    RC_ASSERT(result.repairs.flipped_triangles == turned_over);
}

TEST(Solids, ThousandsOfShellsTakeNoQuadraticStep)
{
    // Ten thousand cubes side by side in a box, and two thousand in one another: with a test for each pair this takes
    // minutes.
    TriangleSoup many;
    for (int i = 0; i < 10000; ++i) {
        const int x = i % 25, y = i / 25 % 20, z = i / 500;
        const TriangleSoup one = inside_out(cube(glm::vec3(float(x), float(y), float(z)), 0.5f));
        const auto offset = static_cast<std::uint32_t>(many.vertices.size());
        many.vertices.insert(many.vertices.end(), one.vertices.begin(), one.vertices.end());
        for (const auto& [a, b, c] : one.triangles) many.triangles.push_back({a + offset, b + offset, c + offset});
    }
    many.has_normals = false;
    const Repaired cheese = repair(many + cube(glm::vec3(-1.0f), 30.0f));
    EXPECT_TRUE(cheese.repairs.none());
    EXPECT_EQ(cheese.mesh->groups.size(), 1u);

    TriangleSoup onion;
    for (int i = 0; i < 2000; ++i) {
        const TriangleSoup one = cube(glm::vec3(float(-i - 1)), float(2 * i + 2));
        const auto offset = static_cast<std::uint32_t>(onion.vertices.size());
        onion.vertices.insert(onion.vertices.end(), one.vertices.begin(), one.vertices.end());
        for (const auto& [a, b, c] : one.triangles)
            onion.triangles.push_back(i % 2 == 1 ? Triangle{a + offset, b + offset, c + offset}
                                                 : Triangle{a + offset, c + offset, b + offset});
    }
    onion.has_normals = false;
    const Repaired peeled = repair(onion);
    EXPECT_TRUE(peeled.repairs.none());
    EXPECT_EQ(peeled.mesh->groups.size(), 1000u);
}

}  // namespace
}  // namespace kerf::core
