#include "common/caps/outline_loops.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "common/caps/section_area.h"

namespace kerf::core {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using PointsOfLoops = std::vector<std::vector<std::uint32_t>>;

const Plane kPlane{{0, 0, 1}, 0.0};

std::vector<OutlineEdge> outline_of(const std::vector<Edge>& edges)
{
    std::vector<OutlineEdge> outline;
    for (const auto& [from, to] : edges) outline.push_back({from, to, {}, static_cast<std::uint32_t>(outline.size())});
    return outline;
}

/// Points on a circle in z = 0.
std::vector<glm::vec3> circle(const std::vector<Edge>& edges)
{
    std::uint32_t count = 0;
    for (const auto& [from, to] : edges) count = std::max({count, from + 1, to + 1});
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < count; ++i) points.push_back({std::cos(float(i)), std::sin(float(i)), 0.0f});
    return points;
}

DividedOutline divide(const std::vector<Edge>& edges, const std::vector<std::uint64_t>& tags = {})
{
    return divide_outline(kPlane, circle(edges), outline_of(edges), tags);
}

/// The points that each path comes by, the smallest one first where it is closed; sorted.
PointsOfLoops all_points(const DividedOutline& divided, const std::vector<Edge>& edges)
{
    PointsOfLoops all;
    for (const OutlinePath& path : divided.paths) {
        std::vector<std::uint32_t>& points = all.emplace_back();
        for (std::size_t i = 0; i < path.count; ++i) points.push_back(edges[divided.edges[path.first + i]][0]);
        if (path.closed)
            std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
        else
            points.push_back(edges[divided.edges[path.first + path.count - 1]][1]);
    }
    std::sort(all.begin(), all.end());
    return all;
}

std::ptrdiff_t closed_paths(const DividedOutline& divided)
{
    return std::count_if(divided.paths.begin(), divided.paths.end(), [](const OutlinePath& p) { return p.closed; });
}

TEST(DivideOutline, ALoopComesOutInOrder)
{
    const std::vector<Edge> edges{{2, 3}, {0, 1}, {3, 0}, {1, 2}};
    const DividedOutline divided = divide(edges);
    EXPECT_EQ(closed_paths(divided), 1);
    EXPECT_EQ(all_points(divided, edges), (PointsOfLoops{{0, 1, 2, 3}}));
}

TEST(DivideOutline, TwoLoopsThatShareAPointComeApart)
{
    const std::vector<Edge> edges{{1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}, {0, 1}};
    const DividedOutline divided = divide(edges);
    EXPECT_EQ(all_points(divided, edges), (PointsOfLoops{{0, 1, 2}, {0, 3, 4}}));
    EXPECT_EQ(closed_paths(divided), 2);
}

TEST(DivideOutline, AFigureEightOfTwoEdgeLoopsComesApart)
{
    const std::vector<Edge> edges{{1, 0}, {0, 2}, {2, 0}, {0, 1}};
    EXPECT_EQ(all_points(divide(edges), edges), (PointsOfLoops{{0, 1}, {0, 2}}));
}

TEST(DivideOutline, AChainBeginsWhereNothingLeadsTo)
{
    const std::vector<Edge> edges{{1, 2}, {2, 3}, {0, 1}};
    const DividedOutline divided = divide(edges);
    EXPECT_EQ(closed_paths(divided), 0);
    EXPECT_EQ(all_points(divided, edges), (PointsOfLoops{{0, 1, 2, 3}}));
}

TEST(DivideOutline, AChainThroughAPointOfALoopLeavesTheLoopWhole)
{
    const std::vector<Edge> edges{{0, 1}, {1, 2}, {2, 0}, {5, 0}, {0, 6}};
    const DividedOutline divided = divide(edges);
    EXPECT_EQ(all_points(divided, edges), (PointsOfLoops{{0, 1, 2}, {5, 0, 6}}));
    EXPECT_EQ(closed_paths(divided), 1);
}

TEST(DivideOutline, SeveralChainsFromOnePoint)
{
    const std::vector<Edge> edges{{0, 1}, {0, 2}, {0, 3}};
    EXPECT_EQ(all_points(divide(edges), edges), (PointsOfLoops{{0, 1}, {0, 2}, {0, 3}}));
}

TEST(DivideOutline, OnlyEdgesOfOneTagFollowOneAnother)
{
    // At the shared point 0 either continuation fits; the tags say which.
    const std::vector<Edge> edges{{1, 2}, {2, 0}, {0, 3}, {3, 4}, {4, 0}, {0, 1}};
    EXPECT_EQ(all_points(divide(edges, {7, 7, 9, 9, 9, 7}), edges), (PointsOfLoops{{0, 1, 2}, {0, 3, 4}}));
    EXPECT_EQ(all_points(divide(edges, {7, 7, 7, 7, 9, 7}), edges), (PointsOfLoops{{0, 1, 2}, {0, 3, 4}, {4, 0}}));
}

TEST(DivideOutline, APathTakesTheEdgeThatLeadsToTheLeastPointAndOfThoseTheOneOfTheLeastSource)
{
    // From 0 by 1, or by 2, to 3; back to 0 only once. 3 and 4 are in one place.
    const std::vector<glm::vec3> points{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {3, 0, 0}, {3, 0, 0}};
    const std::vector<OutlineEdge> by_place{{0, 1, {}, 0}, {0, 2, {}, 1}, {1, 3, {}, 2}, {2, 3, {}, 3}, {3, 0, {}, 4}};
    const DividedOutline divided = divide_outline(kPlane, points, by_place);
    ASSERT_EQ(divided.paths.size(), 2u);
    EXPECT_TRUE(divided.paths[0].closed);
    EXPECT_EQ(divided.edges, (std::vector<std::uint32_t>{1, 3, 4, 0, 2}));

    const std::vector<OutlineEdge> by_source{{0, 3, {}, 8}, {0, 4, {}, 7}, {3, 0, {}, 1}, {4, 0, {}, 2}, {0, 1, {}, 3}};
    // Only source 7 goes before source 8; the chain ends in 1.
    EXPECT_EQ(divide_outline(kPlane, points, by_source).edges, (std::vector<std::uint32_t>{4, 1, 3, 0, 2}));
}

/// Random walks over few points: they share points and run over one another.
std::vector<Edge> random_walks(bool closed, std::vector<std::uint64_t>& tags)
{
    std::vector<Edge> edges;
    const auto walks = *rc::gen::inRange<std::uint32_t>(1, 5);
    for (std::uint32_t w = 0; w < walks; ++w) {
        const auto points = *rc::gen::resize(20, rc::gen::nonEmpty(rc::gen::container<std::vector<std::uint32_t>>(
                                                     rc::gen::resize(100, rc::gen::inRange<std::uint32_t>(0, 8)))));
        for (std::size_t i = 0; i + (closed ? 0 : 1) < points.size(); ++i) {
            const Edge edge{points[i], points[(i + 1) % points.size()]};
            if (edge[0] == edge[1]) continue;
            edges.push_back(edge);
            tags.push_back(w % 2);
        }
    }
    return edges;
}

RC_GTEST_PROP(DivideOutline, EveryEdgeIsOnOneSimplePathWithAsFewChainsAsCanBe, ())
{
    std::vector<std::uint64_t> tags;
    const std::vector<Edge> edges = random_walks(*rc::gen::arbitrary<bool>(), tags);
    RC_PRE(!edges.empty());
    const DividedOutline divided = divide(edges, tags);
    std::vector<std::uint32_t> used(edges.size(), 0);
    std::ptrdiff_t chains = 0;
    for (const OutlinePath& path : divided.paths) {
        std::set<std::uint32_t> visited;
        for (std::size_t i = 0; i < path.count; ++i) {
            const std::uint32_t e = divided.edges[path.first + i];
            RC_ASSERT(tags[e] == tags[divided.edges[path.first]]);
            RC_ASSERT(visited.insert(edges[e][0]).second);
            ++used[e];
            const bool is_last = i + 1 == path.count;
            if (is_last && !path.closed) RC_ASSERT(visited.count(edges[e][1]) == 0u);
            if (!is_last || path.closed)
                RC_ASSERT(edges[e][1] == edges[divided.edges[path.first + (is_last ? 0 : i + 1)]][0]);
        }
        chains += path.closed ? 0 : 1;
    }
    RC_ASSERT(std::all_of(used.begin(), used.end(), [](std::uint32_t count) { return count == 1; }));
    std::map<std::pair<std::uint32_t, std::uint64_t>, int> surplus;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        ++surplus[{edges[e][0], tags[e]}];
        --surplus[{edges[e][1], tags[e]}];
    }
    std::ptrdiff_t expected = 0;
    for (const auto& [point, count] : surplus) expected += std::max(count, 0);
    RC_ASSERT(chains == expected);
}

RC_GTEST_PROP(DivideOutline, DependsNeitherOnTheOrderOfEdgesNorOnNumbersNorOnTheSideItIsSeenFrom, ())
{
    std::vector<std::uint64_t> tags;
    const std::vector<Edge> edges = random_walks(false, tags);
    RC_PRE(!edges.empty());
    std::vector<glm::vec3> points;
    // Some points are in one place.
    for (std::uint32_t i = 0; i < 8; ++i) {
        const std::uint32_t x = i / 2 % 2, y = i / 4;
        points.push_back({float(x), float(y), 0.0f});
    }
    const std::vector<OutlineEdge> outline = outline_of(edges);

    std::mt19937 random(*rc::gen::inRange(0u, 1000000u));
    std::vector<std::uint32_t> place(points.size()), number(edges.size());
    for (std::uint32_t i = 0; i < place.size(); ++i) place[i] = i;
    for (std::uint32_t i = 0; i < number.size(); ++i) number[i] = i;
    std::shuffle(place.begin(), place.end(), random);
    std::shuffle(number.begin(), number.end(), random);
    const bool flipped = *rc::gen::arbitrary<bool>();
    std::vector<glm::vec3> other_points(points.size());
    std::vector<OutlineEdge> other(edges.size());
    std::vector<std::uint64_t> other_tags(edges.size());
    for (std::uint32_t i = 0; i < points.size(); ++i) other_points[place[i]] = points[i];
    for (std::uint32_t i = 0; i < edges.size(); ++i) {
        OutlineEdge& edge = other[number[i]] = outline[i];
        edge.from = place[edge.from];
        edge.to = place[edge.to];
        if (flipped) std::swap(edge.from, edge.to);
        other_tags[number[i]] = tags[i];
    }

    /// Paths as sets of sources: these name the edges.
    const auto paths_of = [&](const DividedOutline& divided, const std::vector<OutlineEdge>& list) {
        std::vector<std::pair<bool, std::set<std::uint32_t>>> paths;
        for (const OutlinePath& path : divided.paths) {
            auto& [closed, sources] = paths.emplace_back();
            closed = path.closed;
            for (std::size_t i = 0; i < path.count; ++i) sources.insert(list[divided.edges[path.first + i]].source);
        }
        std::sort(paths.begin(), paths.end());
        return paths;
    };
    RC_ASSERT(paths_of(divide_outline(kPlane, points, outline, tags), outline) ==
              paths_of(divide_outline(flipped ? kPlane.flipped() : kPlane, other_points, other, other_tags), other));
}

TEST(OppositeEdges, ArePairedAsOftenAsThereAreBoth)
{
    const std::vector<Edge> edges{{0, 1}, {1, 2}, {1, 0}, {0, 1}, {0, 1}, {1, 0}, {2, 0}};
    const auto pairs = opposite_edges(3, outline_of(edges));
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[0], (std::array<std::uint32_t, 2>{0, 2}));
    EXPECT_EQ(pairs[1], (std::array<std::uint32_t, 2>{3, 5}));
}

TEST(SectionArea, IsPositiveCounterClockwiseSeenFromThePositiveSideAndHasTheSameBitsInAnyOrder)
{
    const std::vector<glm::vec3> square{{5, 5, 1}, {7, 5, 1}, {7, 8, 1}, {5, 8, 1}};
    const auto area = [](const Plane& plane, const std::vector<glm::vec3>& loop, std::size_t first) {
        return section_area(plane, [&](auto visit) {
            for (std::size_t i = 0; i < loop.size(); ++i)
                visit(loop[(first + i) % loop.size()], loop[(first + i + 1) % loop.size()]);
        });
    };
    EXPECT_EQ(area(kPlane, square, 0), 6.0);
    EXPECT_EQ(area(kPlane.flipped(), square, 0), -6.0);
    EXPECT_EQ(section_area(kPlane, [](auto) {}), 0.0);
    std::vector<glm::vec3> round;
    for (int i = 0; i < 1000; ++i) round.push_back({1e3f + std::cos(float(i) / 160), std::sin(float(i) / 160), 0.0f});
    for (std::size_t first = 1; first < round.size(); first += 111)
        EXPECT_EQ(area(kPlane, round, 0), area(kPlane, round, first));
}

}  // namespace
}  // namespace kerf::core
