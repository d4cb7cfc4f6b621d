#include "common/sections/loop_nesting.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/sections/section_measures.h"
#include "common/support/random.h"

namespace kerf::core {
namespace {

const Plane kSheet{{0, 0, 1}, 0};
using Parents = std::vector<std::uint32_t>;

void add_loop(PlaneSection& section, const std::vector<glm::vec3>& points)
{
    section.paths.push_back({section.points.size(), points.size(), section.edges.size(), points.size(), 0, true});
    section.points.insert(section.points.end(), points.begin(), points.end());
    section.edges.resize(section.edges.size() + points.size());
}

void add_rectangle(PlaneSection& section, float x0, float y0, float x1, float y1, bool is_hole)
{
    std::vector<glm::vec3> corners{{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
    if (is_hole) std::reverse(corners.begin(), corners.end());
    add_loop(section, corners);
}

Parents parents_of(PlaneSection& section, const Plane& plane = kSheet)
{
    measure_section(plane, section);
    LoopNesting nesting;
    const std::span<const std::uint32_t> found = nesting.find(plane, section);
    return {found.begin(), found.end()};
}

TEST(LoopNesting, NothingLiesInNothing)
{
    PlaneSection section;
    EXPECT_TRUE(parents_of(section).empty());
    add_rectangle(section, 0, 0, 1, 1, false);
    EXPECT_EQ(parents_of(section), Parents{kNoContainer});
}

TEST(LoopNesting, AnIslandLiesInTheHoleAndTheHoleInItsLoop)
{
    PlaneSection section;
    add_rectangle(section, 4, 4, 5, 5, false);
    add_rectangle(section, 0, 0, 10, 10, false);
    add_rectangle(section, 2, 2, 8, 8, true);
    add_rectangle(section, 20, 0, 30, 10, false);
    EXPECT_EQ(parents_of(section), (Parents{2, kNoContainer, 1, kNoContainer}));
}

TEST(LoopNesting, WhatFillsAHoleLiesInIt)
{
    for (const bool filling_first : {false, true}) {
        PlaneSection section;
        if (filling_first) add_rectangle(section, 2, 2, 8, 8, false);
        add_rectangle(section, 0, 0, 10, 10, false);
        add_rectangle(section, 2, 2, 8, 8, true);
        if (!filling_first) add_rectangle(section, 2, 2, 8, 8, false);
        EXPECT_EQ(parents_of(section), filling_first ? (Parents{2, kNoContainer, 1}) : (Parents{kNoContainer, 0, 1}));
    }
}

TEST(LoopNesting, LoopsThatTouchInPointsAndEdgesAreToldApart)
{
    PlaneSection section;
    add_rectangle(section, 0, 0, 10, 10, false);
    add_rectangle(section, 0, 0, 5, 5, true);      // shares a corner and parts of two sides
    add_rectangle(section, 10, 0, 20, 10, false);  // shares a side from outside
    add_rectangle(section, 5, 5, 8, 8, true);      // touches the first hole in a corner
    EXPECT_EQ(parents_of(section), (Parents{kNoContainer, 0, kNoContainer, 0}));
}

TEST(LoopNesting, ChainsLieInNoneAndHoldNone)
{
    PlaneSection section;
    add_rectangle(section, 0, 0, 10, 10, false);
    section.paths.push_back({section.points.size(), 3, section.edges.size(), 2, 0, false});
    for (const glm::vec3& p : {glm::vec3(1, 1, 0), glm::vec3(2, 1, 0), glm::vec3(2, 2, 0)}) section.points.push_back(p);
    section.edges.resize(section.edges.size() + 2);
    EXPECT_EQ(parents_of(section), (Parents{kNoContainer, kNoContainer}));
}

/// A star with random rays around a centre, which lies in a circle of `radius` and has a circle of a quarter inside.
std::vector<glm::vec3> star(Random& random, glm::vec2 centre, float radius, bool is_hole)
{
    const int count = 5 + int(random.below(20));
    std::vector<glm::vec3> points;
    for (int i = 0; i < count; ++i) {
        const float angle = float(2.0 * std::numbers::pi * i / count);
        const float reach = radius * (0.5f + 0.5f * float(random.below(1000)) / 1000.0f);
        points.emplace_back(centre.x + reach * std::cos(angle), centre.y + reach * std::sin(angle), 0.0f);
    }
    if (is_hole) std::reverse(points.begin(), points.end());
    return points;
}

void add_stars(Random& random, PlaneSection& section, Parents& expected, glm::vec2 centre, float radius,
               std::uint32_t around, bool is_hole, int depth)
{
    const auto own = static_cast<std::uint32_t>(section.paths.size());
    add_loop(section, star(random, centre, radius, is_hole));
    expected.push_back(around);
    if (depth == 0) return;
    // A circle of two fifths of the radius lies inside any star; four small ones have room in half of that.
    const float each = radius / 16.0f;
    for (const glm::vec2 corner : {glm::vec2(1, 1), glm::vec2(-1, 1), glm::vec2(-1, -1), glm::vec2(1, -1)})
        if (random.below(3) != 0)
            add_stars(random, section, expected, centre + corner * (1.5f * each), each, own, !is_hole, depth - 1);
}

RC_GTEST_PROP(LoopNesting, IsThatOfTheStarsInStars, (std::uint64_t seed))
{
    Random random(seed);
    PlaneSection section;
    Parents expected;
    for (int i = 0; i < 3; ++i)
        add_stars(random, section, expected, {300.0f * float(i), 0.0f}, 100.0f, kNoContainer, false, 3);
    RC_ASSERT(parents_of(section) == expected);
}

TEST(LoopNesting, IsTheSameAlongEveryAxis)
{
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {1.0, -1.0}) {
            PlaneSection section;
            add_rectangle(section, 0, 0, 10, 10, sign < 0);
            add_rectangle(section, 2, 2, 8, 8, sign > 0);
            Plane plane{{0, 0, 0}, 0.0};
            plane.normal[axis] = sign;
            for (glm::vec3& p : section.points) {
                glm::vec3 turned{0.0f};
                turned[(axis + 1) % 3] = p.x;
                turned[(axis + 2) % 3] = p.y;
                p = turned;
            }
            EXPECT_EQ(parents_of(section, plane), (Parents{kNoContainer, 0}));
            EXPECT_GT(section.paths[0].area, 0.0);
        }
}

}  // namespace
}  // namespace kerf::core
