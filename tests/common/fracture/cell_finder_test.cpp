#include "common/fracture/cell_finder.h"

#include <gtest/gtest.h>

#include "common/mesh/index.h"
#include "support/fixtures.h"

namespace kerf::core {
namespace {

const Box kSpace{glm::vec3(-1.0f), glm::vec3(1.0f)};

glm::dvec3 any_place(test::Random& random)
{
    return {2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0, 2.0 * random.uniform() - 1.0};
}

CellDiagram diagram_of(std::size_t sites, test::Random& random)
{
    std::vector<glm::dvec3> places;
    while (places.size() < sites) places.push_back(any_place(random));
    return *make_cell_diagram(places, kSpace);
}

/// By looking at all sites.
std::uint32_t nearest_site(const CellDiagram& diagram, const glm::vec3& point)
{
    std::uint32_t nearest = 0;
    for (std::uint32_t s = 1; s < diagram.sites.size(); ++s)
        if (squared_distance_to_site(point, diagram.sites[s]) < squared_distance_to_site(point, diagram.sites[nearest]))
            nearest = s;
    return nearest;
}

TEST(CellFinder, FindsTheNearestSiteOfPoints)
{
    test::Random random(1);
    for (const std::size_t sites : {1u, 2u, 5u, 60u}) {
        const CellDiagram diagram = diagram_of(sites, random);
        CellFinder finder(diagram);
        for (int i = 0; i < 2000; ++i) {
            const glm::vec3 point(any_place(random));
            EXPECT_EQ(finder.cell_of(point), nearest_site(diagram, point));
        }
    }
}

TEST(CellFinder, AllPointsOfABoxInACellAreInIt)
{
    test::Random random(2);
    const CellDiagram diagram = diagram_of(40, random);
    CellFinder finder(diagram);
    std::size_t in_one = 0, in_several = 0;
    for (int i = 0; i < 3000; ++i) {
        const glm::dvec3 middle = any_place(random), half = 0.15 * random.uniform() * glm::dvec3(1.0, 0.5, 0.7);
        const Box box{glm::vec3(middle - half), glm::vec3(middle + half)};
        const std::uint32_t cell = finder.cell_of(box);
        ++(cell == kNone ? in_several : in_one);
        if (cell == kNone) continue;
        // Corners lie farthest out: cells are convex.
        for (int c = 0; c < 8; ++c) {
            const glm::vec3 corner((c & 1) != 0 ? box.hi.x : box.lo.x, (c & 2) != 0 ? box.hi.y : box.lo.y,
                                   (c & 4) != 0 ? box.hi.z : box.lo.z);
            EXPECT_EQ(nearest_site(diagram, corner), cell);
        }
    }
    EXPECT_GT(in_one, 500u);
    EXPECT_GT(in_several, 500u);
}

TEST(CellFinder, ABoxThatTouchesABorderIsInNoCell)
{
    // The border is at x = 0.5: exactly, in doubles.
    const std::vector<glm::dvec3> sites{{0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}};
    const CellDiagram diagram = *make_cell_diagram(sites, kSpace);
    CellFinder finder(diagram);
    EXPECT_EQ(finder.cell_of(Box{{0.1f, 0.0f, 0.0f}, {0.5f, 0.1f, 0.1f}}), kNone);
    EXPECT_EQ(finder.cell_of(Box{{0.5f, 0.0f, 0.0f}, {0.6f, 0.1f, 0.1f}}), kNone);
    EXPECT_EQ(finder.cell_of(Box{{0.1f, 0.0f, 0.0f}, {0.4999f, 0.1f, 0.1f}}), 0u);
    EXPECT_EQ(finder.cell_of(Box{{0.5001f, 0.0f, 0.0f}, {0.6f, 0.1f, 0.1f}}), 1u);
}

}  // namespace
}  // namespace kerf::core
