#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "common/caps/constrained_triangulator.h"

namespace kerf::core {
namespace {

using Edges = std::vector<std::array<Index, 2>>;

constexpr std::size_t kAnyNumber = 1000;

std::vector<Index> route_of(const EdgeRoutes& routes, std::size_t edge)
{
    return {routes.points.begin() + static_cast<std::ptrdiff_t>(routes.starts[edge]),
            routes.points.begin() + static_cast<std::ptrdiff_t>(routes.starts[edge + 1])};
}

TEST(RouteFinder, LeadsEdgesOverPlacesInThemAndOverWhereTheyCross)
{
    const std::vector<glm::dvec2> places{{0, 0}, {4, 0}, {1, 0}, {3, -1}, {3, 1}};
    EdgeRoutes routes;
    ASSERT_TRUE(make_route_finder()->find(places, Edges{{0, 1}, {3, 4}}, kAnyNumber, kAnyNumber, routes));
    ASSERT_EQ(routes.added.size(), 1u);
    EXPECT_NEAR(glm::distance(routes.added[0], glm::dvec2(3, 0)), 0.0, 1e-15);
    EXPECT_EQ(route_of(routes, 0), (std::vector<Index>{0, 2, 5, 1}));
    EXPECT_EQ(route_of(routes, 1), (std::vector<Index>{3, 5, 4}));
}

TEST(RouteFinder, GivesUpWhereMoreCrossThanAreAllowed)
{
    const std::vector<glm::dvec2> places{{0, 0}, {4, 0}, {3, -1}, {3, 1}};
    EdgeRoutes routes;
    EXPECT_FALSE(make_route_finder()->find(places, Edges{{0, 1}, {2, 3}}, 0, kAnyNumber, routes));
}

TEST(RouteFinder, GivesUpWhereEdgesToAndFroCrossTooManyOthers)
{
    // k times the same edge over k others: k vertices are added, and k * k are on the routes.
    constexpr Index kEdges = 20;
    std::vector<glm::dvec2> places{{0, 0}, {kEdges + 1, 0}};
    Edges edges;
    for (Index i = 0; i < kEdges; ++i) {
        edges.push_back(i % 2 == 0 ? std::array<Index, 2>{0, 1} : std::array<Index, 2>{1, 0});
        edges.push_back({static_cast<Index>(places.size()), static_cast<Index>(places.size() + 1)});
        places.push_back({i + 1, -1});
        places.push_back({i + 1, 1});
    }
    const std::size_t points = kEdges * (kEdges + 2) + kEdges * 3;
    EdgeRoutes routes;
    ASSERT_TRUE(make_route_finder()->find(places, edges, kEdges, points, routes));
    EXPECT_EQ(routes.points.size(), points);
    EXPECT_FALSE(make_route_finder()->find(places, edges, kEdges, points - 1, routes));
}

TEST(RouteFinder, RefusesEqualPlaces)
{
    const std::vector<glm::dvec2> places{{0, 0}, {4, 0}, {0, 0}, {3, 1}};
    EdgeRoutes routes;
    EXPECT_FALSE(make_route_finder()->find(places, Edges{{0, 1}, {2, 3}}, kAnyNumber, kAnyNumber, routes));
    EXPECT_FALSE(make_route_finder()->find(places, Edges{{0, 2}}, kAnyNumber, kAnyNumber, routes));
}

TEST(RouteFinder, RefusesEdgesThatEndAtTheirStart)
{
    const std::vector<glm::dvec2> places{{0, 0}, {4, 0}, {3, 1}};
    EdgeRoutes routes;
    EXPECT_FALSE(make_route_finder()->find(places, Edges{{0, 1}, {2, 2}}, kAnyNumber, kAnyNumber, routes));
}

TEST(RouteFinder, RefusesPlacesInOneLine)
{
    const std::vector<glm::dvec2> places{{0, 0}, {4, 0}, {3, 0}};
    EdgeRoutes routes;
    EXPECT_FALSE(make_route_finder()->find(places, Edges{{0, 1}}, kAnyNumber, kAnyNumber, routes));
}

}  // namespace
}  // namespace kerf::core
