#include "common/caps/holes.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/support/random.h"

namespace kerf::core {
namespace {

const Plane kGround{{0, 0, 1}, 0.0};

/// NestedLoops in z = 0: those of even depth are outer ones, the others holes.
struct NestedLoops
{
    std::vector<std::vector<glm::vec3>> points;
    std::vector<std::uint32_t> inside_of;  ///< the loop around each, or kNoPart
};

/// A star of `corners` points around `centre`, with radii from `radius` / 2 to `radius`.
std::vector<glm::vec3> star_around(Random& random, const glm::vec2& centre, float radius, bool is_outer)
{
    const std::uint32_t corners = 3 + random.below(9);
    std::vector<glm::vec3> points;
    for (std::uint32_t i = 0; i < corners; ++i) {
        const double angle = 6.283185307179586 * (is_outer ? i : corners - i) / corners;
        const double r = radius * (0.5 + 0.5 * random.unit());
        points.push_back({centre.x + float(r * std::cos(angle)), centre.y + float(r * std::sin(angle)), 0.0f});
    }
    return points;
}

/// Stars within a circle, each with up to `depth` generations of stars inside. A star of three or more corners holds
/// the circle of a quarter of its radius; four circles side by side fit into one of that size.
void add_stars(Random& random, const glm::vec2& centre, float radius, std::uint32_t around, bool is_outer, int depth,
               NestedLoops& loops)
{
    const auto own = static_cast<std::uint32_t>(loops.points.size());
    loops.points.push_back(star_around(random, centre, radius, is_outer));
    loops.inside_of.push_back(around);
    if (depth == 0) return;
    const float room = radius / 4.0f, each = room / 3.0f;
    for (const glm::vec2 corner : {glm::vec2(1, 1), glm::vec2(-1, 1), glm::vec2(-1, -1), glm::vec2(1, -1)})
        if (random.below(2) == 0)
            add_stars(random, centre + corner * (room / 2.0f - each / 8.0f), each, own, !is_outer, depth - 1, loops);
}

/// The piece of each loop, as join_holes() finds it.
std::vector<std::uint32_t> piece_of_each(const NestedLoops& loops)
{
    std::vector<glm::vec3> points;
    std::vector<OutlineEdge> edges;
    std::vector<std::vector<std::uint32_t>> paths;
    for (const std::vector<glm::vec3>& loop : loops.points) {
        const auto first = static_cast<std::uint32_t>(points.size()), count = static_cast<std::uint32_t>(loop.size());
        std::vector<std::uint32_t>& path = paths.emplace_back();
        for (std::uint32_t i = 0; i < count; ++i) {
            path.push_back(static_cast<std::uint32_t>(edges.size()));
            edges.push_back({first + i, first + (i + 1) % count, {}, first + i});
        }
        points.insert(points.end(), loop.begin(), loop.end());
    }
    const SectionOutline outline(kGround, points, edges);
    std::vector<FlatLoop> flat;
    for (std::uint32_t part = 0; part < paths.size(); ++part) flat.push_back(flatten(outline, paths[part], part, 2));
    DisjointSets pieces(static_cast<std::uint32_t>(flat.size()));
    join_holes(flat, pieces);
    std::vector<std::uint32_t> piece(flat.size());
    for (std::uint32_t i = 0; i < piece.size(); ++i) piece[i] = pieces.find(i);
    return piece;
}

TEST(Holes, FlatLoopHasItsAreaWhereverItBegins)
{
    const std::vector<glm::vec3> square{{5, 7, 0}, {8, 7, 0}, {8, 9, 0}, {5, 9, 0}};
    const std::vector<OutlineEdge> edges{{0, 1, {}, 0}, {1, 2, {}, 1}, {2, 3, {}, 2}, {3, 0, {}, 3}};
    const SectionOutline outline(kGround, square, edges);
    const std::vector<std::uint32_t> path{0, 1, 2, 3}, later{2, 3, 0, 1};
    const FlatLoop a = flatten(outline, path, 4, 2), b = flatten(outline, later, 4, 2);
    EXPECT_EQ(a.area2, 2.0 * 6.0);
    EXPECT_EQ(b.area2, a.area2);
    EXPECT_EQ(a.part, 4u);
    for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(a.points[i].u, b.points[i].u);
        EXPECT_EQ(a.points[i].v, b.points[i].v);
    }
}

TEST(Holes, EdgesThatRunForthAndBackAreNoOutline)
{
    const std::vector<glm::vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {3, 3, 0}};
    const std::vector<OutlineEdge> edges{{0, 1, {}, 0}, {1, 2, {}, 1}, {2, 0, {}, 2}, {1, 3, {}, 3}, {3, 1, {}, 4}};
    EXPECT_EQ(SectionOutline(kGround, points, edges).edges().size(), 3u);
}

RC_GTEST_PROP(Holes, EachIsJoinedWithTheLoopAroundIt, (std::uint64_t seed))
{
    Random random(seed);
    NestedLoops loops;
    add_stars(random, {0, 0}, 100.0f, kNoPart, true, 3, loops);
    add_stars(random, {250, 10}, 100.0f, kNoPart, true, 3, loops);
    const std::vector<std::uint32_t> piece = piece_of_each(loops);
    std::vector<std::uint32_t> depth(piece.size(), 0);
    for (std::uint32_t i = 0; i < piece.size(); ++i) {
        const std::uint32_t around = loops.inside_of[i];
        if (around != kNoPart) depth[i] = depth[around] + 1;
        const bool is_hole = depth[i] % 2 == 1;
        RC_ASSERT(piece[i] == (is_hole ? piece[around] : i));
    }
}

TEST(Holes, OneThatLiesInNoLoopStaysAlone)
{
    Random random(3);
    NestedLoops loops;
    add_stars(random, {0, 0}, 1.0f, kNoPart, true, 0, loops);
    add_stars(random, {5, 0}, 1.0f, kNoPart, false, 0, loops);
    EXPECT_EQ(piece_of_each(loops), (std::vector<std::uint32_t>{0, 1}));
}

}  // namespace
}  // namespace kerf::core
