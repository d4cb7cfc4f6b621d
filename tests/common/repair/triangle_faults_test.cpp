#include "common/repair/triangle_faults.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <initializer_list>
#include <map>
#include <random>
#include <set>
#include <utility>

namespace kerf::core {
namespace {

using List = std::vector<TriangleFault>;
using enum TriangleFault;

/// A tetrahedron with its faces outside.
std::vector<Triangle> tetrahedron_of(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
{
    return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

std::vector<Triangle> together(std::initializer_list<std::vector<Triangle>> parts)
{
    std::vector<Triangle> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    return all;
}

List faults_of(const std::vector<Triangle>& corners)
{
    return find_faults(16, corners).of;
}

TEST(Duplicates, OfATriangleOnItsOwnAreDropped)
{
    EXPECT_EQ(faults_of({{0, 1, 2}, {1, 2, 0}, {2, 0, 1}}), (List{none, duplicate, duplicate}));
}

TEST(Duplicates, OfOneFaceOfAClosedSurfaceAreDropped)
{
    EXPECT_EQ(faults_of(together({tetrahedron_of(0, 1, 2, 3), {{3, 1, 2}}})),
              (List{none, none, none, none, duplicate}));
}

TEST(Duplicates, OfAWholeShellAreDropped)
{
    const auto shell = tetrahedron_of(0, 1, 2, 3);
    List expected(12, duplicate);
    std::fill_n(expected.begin(), 4, none);
    EXPECT_EQ(faults_of(together({shell, shell, shell})), expected);
}

// dup.obj: each tetrahedron needs a base of its own.
TEST(Duplicates, ThatAreTheFaceOfAnotherSolidStay)
{
    const auto one = tetrahedron_of(0, 1, 2, 3), two = tetrahedron_of(0, 1, 2, 4);
    EXPECT_EQ(faults_of(together({one, two})), (List{none, none, none, none, coinciding, none, none, none}));
    EXPECT_EQ(faults_of(together({one, two, tetrahedron_of(0, 1, 2, 5)})),
              (List{none, none, none, none, coinciding, none, none, none, coinciding, none, none, none}));
}

TEST(Duplicates, AreDroppedDownToThoseThatAreNeeded)
{
    const auto solids = together({tetrahedron_of(0, 1, 2, 3), tetrahedron_of(0, 1, 2, 4)});
    EXPECT_EQ(faults_of(together({solids, {{2, 1, 0}}})),
              (List{none, none, none, none, coinciding, none, none, none, duplicate}));
    // A shell that is there twice, of which another solid has one face, too.
    EXPECT_EQ(faults_of(together({tetrahedron_of(0, 1, 2, 3), solids})),
              (List{none, none, none, none, duplicate, duplicate, duplicate, duplicate, coinciding, none, none, none}));
}

TEST(Duplicates, OfAnOpenSheetAreDropped)
{
    const std::vector<Triangle> sheet{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}};
    EXPECT_EQ(faults_of(together({sheet, sheet})), (List{none, none, none, duplicate, duplicate, duplicate}));
}

TEST(Duplicates, AreNotWhatRunsTheOtherWay)
{
    EXPECT_EQ(faults_of({{0, 1, 2}, {0, 2, 1}}), (List{none, none}));
}

TEST(Duplicates, AreNotDegenerateTriangles)
{
    EXPECT_EQ(faults_of({{0, 1, 1}, {0, 1, 1}, {2, 2, 2}, {0, 1, 2}}),
              (List{degenerate, degenerate, degenerate, none}));
}

TEST(Duplicates, AreLookedForWhenTrianglesAreTurnedBack)
{
    auto shells = together({tetrahedron_of(0, 1, 2, 3), tetrahedron_of(0, 1, 2, 3)});
    std::swap(shells[5][1], shells[5][2]);
    const Faults faults = find_faults(16, shells);
    EXPECT_EQ(faults.of, (List{none, none, none, none, duplicate, duplicate, duplicate, duplicate}));
    EXPECT_EQ(faults.turned_over, (Buffer<std::uint8_t>{0, 0, 0, 0, 0, 1, 0, 0}));
    EXPECT_EQ(faults.repeats, 3u);
}

// Turned over, the wall would close one edge of the repeat, which then stays open at its two others.
TEST(Duplicates, AreDroppedWhereAWallStandsAtTheirEdge)
{
    const auto shell = tetrahedron_of(0, 1, 2, 3);
    const Triangle wall{1, 2, 4}, turned{shell[0][0], shell[0][2], shell[0][1]};
    const List expected{none, none, none, none, duplicate, none};
    EXPECT_EQ(faults_of(together({shell, {shell[2], wall}})), expected);
    // Another triangle that is turned over changes nothing of it.
    EXPECT_EQ(faults_of({turned, shell[1], shell[2], shell[3], shell[2], wall}), expected);
}

TEST(Duplicates, TurnNothingOverWhereTheyAreBalanced)
{
    for (const auto& corners :
         {together({tetrahedron_of(0, 1, 2, 3), tetrahedron_of(0, 1, 2, 4)}),
          together({tetrahedron_of(0, 1, 2, 3), tetrahedron_of(0, 1, 2, 3), tetrahedron_of(0, 2, 1, 3)}),
          std::vector<Triangle>{{0, 1, 2}, {0, 1, 2}, {2, 1, 3}, {2, 1, 3}}})
        EXPECT_TRUE(find_faults(16, corners).turned_over.empty());
}

/// A triangle from its smallest point on.
Triangle canonical(Triangle t)
{
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
}

using Balance = std::map<std::pair<std::uint32_t, std::uint32_t>, int>;

void add_edges(Balance& balance, const Triangle& t, int sign)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t a = t[i], b = t[(i + 1) % 3];
        if (a != b) balance[std::minmax(a, b)] += a < b ? sign : -sign;
    }
}

/// Few points, many triangles: solids, their copies, and triangles on their own.
std::vector<Triangle> any_triangles(std::mt19937& random)
{
    const auto below = [&](std::uint32_t bound) { return static_cast<std::uint32_t>(random() % bound); };
    const std::uint32_t points = 4 + below(4);
    const auto point = [&] { return below(points); };
    std::vector<Triangle> corners;
    for (std::uint32_t i = 1 + below(8); i > 0; --i) {
        const std::uint32_t a = point(), b = point(), c = point();
        switch (below(3)) {
            case 0:
                corners.push_back({a, b, c});
                break;
            case 1:
                corners = together({corners, tetrahedron_of(a, b, c, point())});
                break;
            default:
                corners = together({corners, corners});
        }
        if (corners.size() > 100) break;
    }
    std::shuffle(corners.begin(), corners.end(), random);
    return corners;
}

TEST(Duplicates, AreDroppedOnlyWhereNoEdgeIsFartherFromBalance)
{
    std::size_t dropped = 0, kept = 0;
    for (std::uint32_t seed = 0; seed < 5000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const auto given = any_triangles(random);
        const Faults found = find_faults(8, given);
        const List& faults = found.of;
        ASSERT_EQ(faults.size(), given.size());
        std::vector<Triangle> corners = given;
        for (std::size_t t = 0; t < corners.size(); ++t)
            if (found.is_turned_over(t)) std::swap(corners[t][1], corners[t][2]);
        Balance before, after;
        std::map<Triangle, std::vector<TriangleFault>> copies;
        for (std::size_t t = 0; t < corners.size(); ++t) {
            add_edges(before, corners[t], 1);
            const std::set<std::uint32_t> different(corners[t].begin(), corners[t].end());
            ASSERT_EQ(faults[t] == degenerate, different.size() < 3);
            if (faults[t] == none || faults[t] == coinciding) add_edges(after, corners[t], 1);
            if (faults[t] != degenerate) copies[canonical(corners[t])].push_back(faults[t]);
            dropped += faults[t] == duplicate;
            kept += faults[t] == coinciding;
        }
        for (const auto& [edge, balance] : before) ASSERT_LE(std::abs(after[edge]), std::abs(balance));
        for (const auto& [triangle, of] : copies) {
            ASSERT_EQ(of.front(), none);
            ASSERT_EQ(std::count(of.begin(), of.end(), none), 1);
        }
    }
    EXPECT_GT(dropped, 1000u);
    EXPECT_GT(kept, 1000u);
}

TEST(Duplicates, AreAsManyInWhateverOrderTrianglesAndPointsCome)
{
    std::size_t judged = 0;
    for (std::uint32_t seed = 0; seed < 1000; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const auto corners = any_triangles(random);
        std::array<std::uint32_t, 8> number{0, 1, 2, 3, 4, 5, 6, 7};
        std::shuffle(number.begin(), number.end(), random);
        std::vector<std::size_t> order(corners.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
        std::shuffle(order.begin(), order.end(), random);
        std::vector<Triangle> other;
        for (const std::size_t t : order) {
            Triangle renumbered{number[corners[t][0]], number[corners[t][1]], number[corners[t][2]]};
            std::rotate(renumbered.begin(), renumbered.begin() + std::ptrdiff_t(random() % 3), renumbered.end());
            other.push_back(renumbered);
        }
        std::map<Triangle, int> dropped;
        const Faults found = find_faults(8, corners), found_otherwise = find_faults(8, other);
        // Which ones are turned over is a search, and that takes them as they come.
        if (!found.turned_over.empty() || !found_otherwise.turned_over.empty()) continue;
        ++judged;
        const List &faults = found.of, &others = found_otherwise.of;
        for (std::size_t i = 0; i < order.size(); ++i) {
            dropped[canonical(corners[i])] += faults[i] == duplicate;
            dropped[canonical(corners[order[i]])] -= others[i] == duplicate;
        }
        for (const auto& [triangle, difference] : dropped) ASSERT_EQ(difference, 0);
    }
    EXPECT_GT(judged, 400u);
}

}  // namespace
}  // namespace kerf::core
