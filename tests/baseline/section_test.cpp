#include "baseline/section.h"

#include <gtest/gtest.h>

#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace kerf::baseline {
namespace {

using Edge = std::array<std::uint32_t, 2>;

/// A section of these edges between points on a circle in z = 0.
Section section_of(const std::vector<Edge>& edges)
{
    Section section;
    std::uint32_t point_count = 0;
    for (const auto& [from, to] : edges) {
        section.edges.push_back({from, to, kNone, 0, 0, 1, 0});
        point_count = std::max({point_count, from + 1, to + 1});
    }
    for (std::uint32_t i = 0; i < point_count; ++i)
        section.points.push_back({{std::cos(float(i)), std::sin(float(i)), 0.0f}, i, kNone});
    return section;
}

std::vector<SectionPath> link(const std::vector<Edge>& edges, std::vector<std::uint32_t> tags = {})
{
    tags.resize(edges.size(), 0);
    return link_paths(section_of(edges), tags);
}

/// The points that a path comes by, the smallest one first where it is closed.
std::vector<std::uint32_t> points_of(const SectionPath& path, const std::vector<Edge>& edges)
{
    std::vector<std::uint32_t> points;
    for (const std::uint32_t e : path.edges) points.push_back(edges[e][0]);
    if (path.closed)
        std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
    else
        points.push_back(edges[path.edges.back()][1]);
    return points;
}

using Points = std::vector<std::vector<std::uint32_t>>;

Points all_points(const std::vector<SectionPath>& paths, const std::vector<Edge>& edges)
{
    Points all;
    for (const SectionPath& path : paths) all.push_back(points_of(path, edges));
    std::sort(all.begin(), all.end());
    return all;
}

TEST(LinkPaths, ALoopComesOutInOrder)
{
    const std::vector<Edge> edges{{2, 3}, {0, 1}, {3, 0}, {1, 2}};
    const auto paths = link(edges);
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_TRUE(paths[0].closed);
    EXPECT_EQ(all_points(paths, edges), (Points{{0, 1, 2, 3}}));
}

TEST(LinkPaths, TwoLoopsThatShareAPointComeApart)
{
    // Started away from the shared point 0, so that the way leads through it.
    const std::vector<Edge> edges{{1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}, {0, 1}};
    const auto paths = link(edges);
    EXPECT_EQ(all_points(paths, edges), (Points{{0, 1, 2}, {0, 3, 4}}));
    EXPECT_TRUE(paths[0].closed && paths[1].closed);
}

TEST(LinkPaths, AFigureEightOfTwoEdgeLoopsComesApart)
{
    const std::vector<Edge> edges{{1, 0}, {0, 2}, {2, 0}, {0, 1}};
    EXPECT_EQ(all_points(link(edges), edges), (Points{{0, 1}, {0, 2}}));
}

TEST(LinkPaths, AChainBeginsWhereNothingLeadsTo)
{
    const std::vector<Edge> edges{{1, 2}, {2, 3}, {0, 1}};
    const auto paths = link(edges);
    ASSERT_EQ(paths.size(), 1u);
    EXPECT_FALSE(paths[0].closed);
    EXPECT_EQ(points_of(paths[0], edges), (std::vector<std::uint32_t>{0, 1, 2, 3}));
}

TEST(LinkPaths, AChainThroughAPointOfALoopLeavesTheLoopWhole)
{
    const std::vector<Edge> edges{{0, 1}, {1, 2}, {2, 0}, {5, 0}, {0, 6}};
    const auto paths = link(edges);
    ASSERT_EQ(paths.size(), 2u);
    EXPECT_EQ(all_points(paths, edges), (Points{{0, 1, 2}, {5, 0, 6}}));
    EXPECT_EQ(std::count_if(paths.begin(), paths.end(), [](const SectionPath& path) { return path.closed; }), 1);
}

TEST(LinkPaths, SeveralChainsFromOnePoint)
{
    const std::vector<Edge> edges{{0, 1}, {0, 2}, {0, 3}};
    const auto paths = link(edges);
    EXPECT_EQ(all_points(paths, edges), (Points{{0, 1}, {0, 2}, {0, 3}}));
}

TEST(LinkPaths, OnlyEdgesOfOneTagFollowOneAnother)
{
    // At the shared point 0 either continuation fits; the tags say which.
    const std::vector<Edge> edges{{1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}, {0, 1}};
    const auto paths = link(edges, {7, 7, 9, 9, 9, 7});
    ASSERT_EQ(paths.size(), 2u);
    for (const SectionPath& path : paths)
        EXPECT_EQ(points_of(path, edges),
                  path.tag == 7 ? (std::vector<std::uint32_t>{0, 1, 2}) : (std::vector<std::uint32_t>{0, 3, 4}));
}

RC_GTEST_PROP(LinkPaths, EveryEdgeOfAnyCirculationIsOnOneSimpleLoop, ())
{
    // Random closed walks over few points: they share points and run over one another.
    std::vector<Edge> edges;
    std::vector<std::uint32_t> tags;
    const auto walks = *rc::gen::inRange<std::uint32_t>(1, 5);
    for (std::uint32_t w = 0; w < walks; ++w) {
        const auto points = *rc::gen::resize(20, rc::gen::nonEmpty(rc::gen::container<std::vector<std::uint32_t>>(
                                                     rc::gen::resize(100, rc::gen::inRange<std::uint32_t>(0, 8)))));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Edge edge{points[i], points[(i + 1) % points.size()]};
            if (edge[0] == edge[1]) continue;
            edges.push_back(edge);
            tags.push_back(w % 2);
        }
    }
    RC_PRE(!edges.empty());
    std::vector<std::uint32_t> used(edges.size(), 0);
    for (const SectionPath& path : link(edges, tags)) {
        RC_ASSERT(path.closed);
        std::set<std::uint32_t> visited;
        for (std::size_t i = 0; i < path.edges.size(); ++i) {
            const std::uint32_t e = path.edges[i], next = path.edges[(i + 1) % path.edges.size()];
            RC_ASSERT(edges[e][1] == edges[next][0]);
            RC_ASSERT(tags[e] == path.tag);
            RC_ASSERT(visited.insert(edges[e][0]).second);
            ++used[e];
        }
    }
    RC_ASSERT(std::all_of(used.begin(), used.end(), [](std::uint32_t count) { return count == 1; }));
}

TEST(SignedArea, IsPositiveCounterClockwiseSeenFromThePositiveSide)
{
    Section section = section_of({{0, 1}, {1, 2}, {2, 3}, {3, 0}});
    section.points[0].position = {5, 5, 1};
    section.points[1].position = {7, 5, 1};
    section.points[2].position = {7, 8, 1};
    section.points[3].position = {5, 8, 1};
    const SectionPath path{{0, 1, 2, 3}, true, 0};
    const Plane plane{{0, 0, 1}, 1};
    EXPECT_EQ(signed_area(section, path, plane), 6.0);
    EXPECT_EQ(signed_area(section, path, plane.flipped()), -6.0);
}

TEST(SectionLoopOfAPath, AnOpenOneHasItsLastPointToo)
{
    const Section section = section_of({{0, 1}, {1, 2}});
    EXPECT_EQ(to_loop(section, {{0, 1}, false, 0}).points.size(), 3u);
    EXPECT_FALSE(to_loop(section, {{0, 1}, false, 0}).closed);
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
    const IndexedMesh mesh = book({true, false});
    Crossings none;
    const std::vector<EdgeInPlane> negative{{0, 0, 0}}, positive{{1, 0, 0}};
    const Section section = find_section(mesh, none, negative, positive);
    ASSERT_EQ(section.edges.size(), 1u);
    EXPECT_EQ(section.points[section.edges[0].from].existing, 1u);
    EXPECT_EQ(section.points[section.edges[0].to].existing, 0u);
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
}  // namespace kerf::baseline
