#include "linear/section.h"

#include <gtest/gtest.h>

namespace kerf::core::linear {
namespace {

using Edge = std::array<std::uint32_t, 2>;

TEST(SectionLoopOfAPath, AnOpenOneHasItsLastPointToo)
{
    Section section;
    for (std::uint32_t i = 0; i < 3; ++i) section.points.push_back({{float(i), 0, 0}, i, kNone});
    for (std::uint32_t i = 0; i < 2; ++i) section.edges.push_back({i, i + 1, kNone, 0, 0, 1, 0, 0});
    EXPECT_EQ(to_loop(section, {{0, 1}, false}).points.size(), 3u);
    EXPECT_FALSE(to_loop(section, {{0, 1}, false}).closed);
}

/// Triangles around the edge from point 0 to point 1; each has a third point of its own.
IndexedMesh book(const std::vector<bool>& ascending)
{
    IndexedMesh mesh;
    const auto add_vertex = [&](const glm::vec3& p) {
        mesh.vertices.push_back({p, {0, 0, 1}, {}});
        mesh.points.push_back(mesh.point_count++);
    };
    add_vertex({0, 0, 0});
    add_vertex({1, 0, 0});
    for (const bool ascends : ascending) {
        add_vertex({0.5f, 1.0f, float(mesh.point_count)});
        const std::uint32_t page = mesh.point_count - 1;
        mesh.triangles.push_back(ascends ? Triangle{0, 1, page} : Triangle{1, 0, page});
        mesh.sources.push_back(0);
    }
    mesh.groups.push_back({0, static_cast<std::uint32_t>(ascending.size()), 0, 0, TriangleKind::surface});
    return mesh;
}

TEST(FindSection, AnEdgeInThePlaneBetweenTheSidesRunsAsOnThePositiveSide)
{
    IndexedMesh mesh = book({true, false});
    mesh.sources = {5, 8};
    Crossings none;
    const std::vector<EdgeInPlane> negative{{0, 0, 0}}, positive{{1, 0, 0}};
    const Section section = find_section(mesh, none, negative, positive);
    ASSERT_EQ(section.edges.size(), 1u);
    EXPECT_EQ(section.points[section.edges[0].from].existing, 1u);
    EXPECT_EQ(section.points[section.edges[0].to].existing, 0u);
    EXPECT_EQ(section.edges[0].source, 5u) << "the smaller source, so that a flipped plane has the same";
}

TEST(FindSection, AnEdgeInThePlaneWithBothTrianglesOnOneSideIsNoSection)
{
    const IndexedMesh mesh = book({true, false, true, false});
    Crossings none;
    const std::vector<EdgeInPlane> negative{{0, 0, 0}, {1, 0, 0}}, positive{{2, 0, 0}, {3, 0, 0}};
    EXPECT_TRUE(find_section(mesh, none, negative, positive).edges.empty());
}

TEST(FindSection, WhereFourTrianglesMeetOnlyThePairThatChangesSidesCounts)
{
    // Three below, of which two bound each other, and one above: one section edge, or the cap would be open.
    const IndexedMesh mesh = book({true, true, false, false});
    Crossings none;
    const std::vector<EdgeInPlane> negative{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, positive{{3, 0, 0}};
    EXPECT_EQ(find_section(mesh, none, negative, positive).edges.size(), 1u);
}

}  // namespace
}  // namespace kerf::core::linear
