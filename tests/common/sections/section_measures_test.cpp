#include "common/sections/section_measures.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace kerf::core {
namespace {

const Plane kPage{{0, 0, 1}, 0};

void add_path(PlaneSection& section, const std::vector<glm::vec3>& points, bool closed)
{
    const std::size_t edges = points.size() - (closed ? 0 : 1);
    section.paths.push_back({section.points.size(), points.size(), section.edges.size(), edges, 0, closed});
    section.points.insert(section.points.end(), points.begin(), points.end());
    section.edges.resize(section.edges.size() + edges);
}

std::vector<glm::vec3> rectangle(float x0, float y0, float x1, float y1)
{
    return {{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}};
}
std::vector<glm::vec3> hole(float x0, float y0, float x1, float y1)
{
    std::vector<glm::vec3> points = rectangle(x0, y0, x1, y1);
    std::reverse(points.begin(), points.end());
    return points;
}

TEST(SectionMeasures, AHoleIsTakenAway)
{
    PlaneSection section;
    add_path(section, rectangle(100, 0, 110, 4), true);
    add_path(section, hole(106, 1, 109, 3), true);
    const SectionMeasures measures = measure_section(kPage, section);
    EXPECT_EQ(section.paths[0].area, 40.0);
    EXPECT_EQ(section.paths[1].area, -6.0);
    EXPECT_EQ(section.paths[0].length, 28.0);
    EXPECT_EQ(section.paths[1].length, 10.0);
    EXPECT_EQ(measures.length, 38.0);
    EXPECT_NEAR(measures.centroid.x, (40.0 * 105.0 - 6.0 * 107.5) / 34.0, 1e-12);
    EXPECT_NEAR(measures.centroid.y, 2.0, 1e-12);
    EXPECT_EQ(measures.box.lo, glm::vec3(100, 0, 0));
    EXPECT_EQ(measures.box.hi, glm::vec3(110, 4, 0));
}

TEST(SectionMeasures, WhatEnclosesNothingHasTheCentreOfItsOutline)
{
    PlaneSection chain;
    add_path(chain, {{0, 0, 0}, {3, 0, 0}, {3, 1, 0}}, false);
    const SectionMeasures measures = measure_section(kPage, chain);
    EXPECT_EQ(chain.paths[0].area, 0.0);
    EXPECT_EQ(measures.length, 4.0);
    EXPECT_NEAR(measures.centroid.x, (3.0 * 1.5 + 1.0 * 3.0) / 4.0, 1e-12);
    EXPECT_NEAR(measures.centroid.y, 0.125, 1e-12);

    // Of equal areas that cancel one another, too.
    PlaneSection both;
    add_path(both, rectangle(0, 0, 1, 1), true);
    add_path(both, hole(4, 0, 5, 1), true);
    EXPECT_NEAR(measure_section(kPage, both).centroid.x, 2.5, 1e-12);

    // And of points in one place.
    PlaneSection point;
    add_path(point, {{2, 3, 0}, {2, 3, 0}, {2, 3, 0}}, true);
    EXPECT_EQ(measure_section(kPage, point).centroid, glm::dvec3(2, 3, 0));
    PlaneSection none;
    EXPECT_EQ(measure_section(kPage, none).centroid, glm::dvec3(0, 0, 0));
}

TEST(SectionMeasures, HaveTheSameBitsWhereverTheLoopsBegin)
{
    std::vector<glm::vec3> loop{{0.1f, 0.7f, 0}, {9.3f, 0.2f, 0}, {7.7f, 5.1f, 0}, {3.3f, 8.9f, 0}, {0.4f, 6.1f, 0}};
    PlaneSection first;
    add_path(first, loop, true);
    const SectionMeasures expected = measure_section(kPage, first);
    for (int i = 0; i < 5; ++i) {
        std::rotate(loop.begin(), loop.begin() + 1, loop.end());
        PlaneSection turned;
        add_path(turned, loop, true);
        const SectionMeasures found = measure_section(kPage, turned);
        EXPECT_EQ(found.centroid, expected.centroid);
        EXPECT_EQ(found.length, expected.length);
        EXPECT_EQ(turned.paths[0].area, first.paths[0].area);
    }
}

TEST(SectionMeasures, OfTheLargestFloatsAreFinite)
{
    const float large = 3e38f;
    PlaneSection section;
    add_path(section, rectangle(-large, -large, large, large), true);
    const SectionMeasures measures = measure_section(kPage, section);
    EXPECT_NEAR(section.paths[0].area / (36e76), 1.0, 1e-6);
    EXPECT_NEAR(measures.centroid.x / 3e38, 0.0, 1e-12);
}

}  // namespace
}  // namespace kerf::core
