#include "baseline/fan.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <set>

#include "baseline/slices.h"
#include "support/referee.h"

namespace kerf::core::baseline {
namespace {

using test::closed_shape;
using test::repaired;

const Plane kAcross{{0, 0, 1}, 0.0};

Slices sliced(const IndexedMesh& mesh, const Plane& plane, const CutOptions& options = {})
{
    return slice(fragment_of(mesh), plane, options, VertexLookup::hash);
}

std::size_t cap_triangles(const IndexedMesh& mesh)
{
    std::size_t count = 0;
    for (const TriangleGroup& group : mesh.groups)
        if (group.kind == TriangleKind::cap) count += group.count;
    return count;
}

bool has_directed_edge_twice(const IndexedMesh& mesh)
{
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (!edges.insert({mesh.points[t[i]], mesh.points[t[(i + 1) % 3]]}).second) return true;
    return false;
}

TEST(Fan, HasATriangleForEachEdgeOfTheRim)
{
    const Slices slices = sliced(closed_shape("cube"), {{0, 0, 1}, 0.125});
    // Four sides of two triangles each.
    for (const Fragment& side : {slices.positive.at(0), slices.negative.at(0)}) {
        ASSERT_EQ(side.section.size(), 1u);
        EXPECT_EQ(side.section[0].points.size(), 8u);
        EXPECT_EQ(cap_triangles(side.mesh), 8u);
        EXPECT_EQ(side.fan_centres.size(), 1u);
    }
}

TEST(Fan, IsCentredOnTheMeanOfTheSection)
{
    const Slices slices = sliced(closed_shape("cube"), {{0, 0, 1}, 0.125});
    const Fragment& side = slices.positive.at(0);
    const glm::vec3 centre = side.mesh.vertices[side.fan_centres.at(0)].position;
    glm::dvec3 mean{0};
    for (const glm::vec3& p : side.section[0].points) mean += glm::dvec3(p) / 8.0;
    EXPECT_NEAR(glm::length(glm::dvec3(centre) - mean), 0.0, 1e-6);
    EXPECT_EQ(centre.z, 0.125f);
}

TEST(Fan, NormalsAreThePlanesFlippedForThePositiveSide)
{
    const Slices slices = sliced(closed_shape("cube"), {{0, 0, 1}, 0.125});
    const auto normal_of_centre = [](const Fragment& side) {
        return side.mesh.vertices[side.fan_centres.at(0)].normal;
    };
    EXPECT_EQ(normal_of_centre(slices.positive.at(0)), glm::vec3(0, 0, -1));
    EXPECT_EQ(normal_of_centre(slices.negative.at(0)), glm::vec3(0, 0, 1));
}

TEST(Fan, EachLoopHasACentreOfItsOwn)
{
    const Slices slices = sliced(closed_shape("pipe"), {{0, 0, 1}, 0.125});
    for (const Fragment& side : {slices.positive.at(0), slices.negative.at(0)}) {
        ASSERT_EQ(side.fan_centres.size(), 2u);
        const auto [a, b] = std::pair{side.fan_centres[0], side.fan_centres[1]};
        EXPECT_EQ(side.mesh.vertices[a].position, side.mesh.vertices[b].position);
        EXPECT_NE(side.mesh.points[a], side.mesh.points[b]);
    }
}

/// A chevron whose inner corner, (0, -1), is the mean of its four: the fan's centre falls on the rim.
IndexedMesh chevron_prism()
{
    return repaired(prism({{0, 3}, {-3, -3}, {0, -1}, {3, -3}}, {{0, 1, 2}, {0, 2, 3}}));
}

TEST(Fan, ACentreOnTheRimMovesAside)
{
    const Slices slices = sliced(chevron_prism(), kAcross);
    ASSERT_EQ(slices.status, Status::done);
    for (const Fragment& side : {slices.positive.at(0), slices.negative.at(0)}) {
        const glm::vec3 centre = side.mesh.vertices[side.fan_centres.at(0)].position;
        EXPECT_NE(centre, glm::vec3(0, -1, 0));
        EXPECT_NEAR(glm::distance(centre, glm::vec3(0, -1, 0)), 0.0f, 1e-6f);
        EXPECT_EQ(referee::open_edges(side.mesh), 0u);
        EXPECT_EQ(referee::triangles_with_equal_corners(side.mesh), 0u);
        // With the rim point itself as centre, a cap edge could run along an edge that the surface has already.
        EXPECT_FALSE(has_directed_edge_twice(side.mesh));
        EXPECT_NEAR(referee::area(side.mesh, TriangleKind::cap), slices.section_area, 1e-5);
    }
}

TEST(Fan, CapsOfDifferentSolidsAreGroupsOfTheirOwn)
{
    const Slices slices = sliced(closed_shape("two_spheres"), {{0, 0, 1}, 0.1});
    std::set<std::uint32_t> solids;
    for (const TriangleGroup& group : slices.negative.at(0).mesh.groups) {
        if (group.kind != TriangleKind::cap) continue;
        EXPECT_TRUE(solids.insert(group.solid).second);
    }
    EXPECT_EQ(solids.size(), 2u);
}

TEST(Fan, AConcaveSectionIsCoveredWronglyAndTheVolumeIsRightAllTheSame)
{
    // A comb cut lengthwise: the mean of its section sees only a part of it. The chain of cap triangles is closed over
    // the same rim in the same plane, so the signed volume is that of the side.
    const IndexedMesh& mesh = closed_shape("comb");
    const Slices slices = sliced(mesh, {{0, 0, 1}, 0.0625});
    const double cap = referee::area(slices.negative.at(0).mesh, TriangleKind::cap);
    EXPECT_GT(cap, slices.section_area * 1.01);
    const double whole = referee::volume(mesh);
    const glm::dvec3 size = glm::dvec3(mesh.bounds().hi) - glm::dvec3(mesh.bounds().lo);
    const double share = (0.0625 - double(mesh.bounds().lo.z)) / size.z;
    EXPECT_NEAR(referee::volume(slices.negative.at(0).mesh), share * whole, 1e-6 * whole);
}

}  // namespace
}  // namespace kerf::core::baseline
