#include "common/repair/vertex_fans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "common/repair/halfedges_by_edge.h"

namespace kerf::core {
namespace {

/// `k` leaves of two triangles each, back to back, that hang on one edge: each is the other's neighbour on the outside,
/// and at the edge the first one's neighbour is the second one of the leaf that `next` says.
LinkedSurface leaves(const std::vector<std::uint32_t>& next, NonmanifoldEdge& edge)
{
    LinkedSurface surface;
    const auto k = static_cast<std::uint32_t>(next.size());
    surface.opposite.assign(6 * next.size(), kNone);
    for (std::uint32_t i = 0; i < k; ++i) {
        surface.corners.push_back({0, 1, 2 + i});
        surface.corners.push_back({1, 0, 2 + i});
        surface.link(6 * i + 1, 6 * i + 5);
        surface.link(6 * i + 2, 6 * i + 4);
        surface.link(6 * i, 6 * next[i] + 3);
        edge.push_back(6 * i);
        edge.push_back(6 * i + 3);
    }
    return surface;
}

/// A single cycle through 0 ... k - 1.
std::vector<std::uint32_t> cycle(std::uint32_t k, std::mt19937& random)
{
    std::vector<std::uint32_t> order(k), next(k);
    std::iota(order.begin(), order.end(), 0u);
    std::shuffle(order.begin(), order.end(), random);
    for (std::uint32_t i = 0; i < k; ++i) next[order[i]] = order[(i + 1) % k];
    return next;
}

/// Calls visit(corner) for each corner of the fan of corner `h`, counter-clockwise; an open fan from its first
/// triangle.
template <class Visit>
void for_each_in_fan(const LinkedSurface& surface, std::uint32_t h, Visit&& visit)
{
    // Clockwise to the beginning of an open fan, or once around a closed one.
    std::uint32_t first = h;
    while (surface.opposite[first] != kNone) {
        first = next_halfedge(surface.opposite[first]);
        if (first == h) break;
    }
    std::uint32_t corner = first;
    do {
        visit(corner);
        corner = surface.opposite[previous_halfedge(corner)];
    } while (corner != kNone && corner != first);
}

/// Fans by the rule in words, edge by edge: every pair of half-edges in order, and whole fans numbered anew.
VertexFans fans_by_the_rule(LinkedSurface& surface, const std::vector<NonmanifoldEdge>& resolved)
{
    constexpr std::uint32_t kNoFan = std::numeric_limits<std::uint32_t>::max();
    VertexFans fans;
    fans.fan.assign(surface.opposite.size(), kNoFan);
    const auto number = [&](std::uint32_t corner) {
        for_each_in_fan(surface, corner, [&](std::uint32_t c) { fans.fan[c] = fans.count; });
        ++fans.count;
    };
    for (std::uint32_t h = 0; h < surface.opposite.size(); ++h)
        if (fans.fan[h] == kNoFan) number(h);
    for (const NonmanifoldEdge& edge : resolved)
        for (std::size_t i = 0; i < edge.size(); ++i)
            for (std::size_t j = i + 1; j < edge.size(); ++j) {
                const std::uint32_t a = edge[i], b = edge[j];
                if (fans.fan[a] != fans.fan[b]) continue;
                if (fans.fan[next_halfedge(a)] != fans.fan[next_halfedge(b)]) continue;
                const std::uint32_t across_a = surface.opposite[a], across_b = surface.opposite[b];
                surface.opposite[a] = surface.opposite[b] = kNone;
                surface.link(a, across_b);
                surface.link(b, across_a);
                number(a);
                number(next_halfedge(a));
            }
    return fans;
}

void expect_the_rule(const LinkedSurface& surface, const std::vector<NonmanifoldEdge>& resolved)
{
    LinkedSurface by_rule = surface, found = surface;
    const VertexFans expected = fans_by_the_rule(by_rule, resolved), fans = find_vertex_fans(found, resolved);
    EXPECT_EQ(fans.count, expected.count);
    EXPECT_EQ(fans.fan, expected.fan);
    EXPECT_EQ(found.opposite, by_rule.opposite);
}

TEST(FindFans, DividesAFanThatPassesAnEdgeAgainAndAgain)
{
    std::mt19937 random(7);
    for (std::uint32_t k = 1; k < 60; ++k) {
        NonmanifoldEdge edge;
        LinkedSurface surface = leaves(cycle(k, random), edge);
        if (k % 2 == 0) std::shuffle(edge.begin(), edge.end(), random);
        if (k % 3 == 0) {  // an open fan
            surface.opposite[surface.opposite[0]] = kNone;
            surface.opposite[0] = kNone;
        }
        SCOPED_TRACE(k);
        expect_the_rule(surface, {edge});
        const VertexFans fans = find_vertex_fans(surface, std::span(&edge, 1));
        // Two ends of the edge for each leaf, and its tip.
        EXPECT_EQ(fans.count, 3 * k);
    }
}

TEST(FindFans, DividesTheSameFansOfAnySurfaceAndNumbersThemInTheSameOrder)
{
    std::mt19937 random(11);
    std::uint64_t exchanges = 0;
    for (int round = 0; round < 400; ++round) {
        // A few points, many triangles, neighbours at random: fans pass most edges more than once.
        const auto below = [&](std::uint32_t n) { return static_cast<std::uint32_t>(random() % n); };
        const std::uint32_t point_count = 4 + below(5), triangle_count = 4 + below(120);
        LinkedSurface surface;
        for (std::uint32_t t = 0; t < triangle_count; ++t) {
            Triangle triangle;
            do
                for (std::uint32_t& point : triangle) point = below(point_count);
            while (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]);
            surface.corners.push_back(triangle);
        }
        surface.opposite.assign(std::size_t{3} * triangle_count, kNone);
        std::vector<NonmanifoldEdge> resolved;
        HalfedgesByEdge(point_count, surface.corners).for_each([&](std::span<const HalfedgesByEdge::Entry> sides) {
            NonmanifoldEdge &edge = resolved.emplace_back(), there, back;
            for (const HalfedgesByEdge::Entry& side : sides) {
                edge.push_back(side.halfedge);
                (surface.start(side.halfedge) < side.larger_point ? there : back).push_back(side.halfedge);
            }
            std::shuffle(there.begin(), there.end(), random);
            for (std::size_t i = 0; i < std::min(there.size(), back.size()); ++i) surface.link(there[i], back[i]);
        });
        SCOPED_TRACE(round);
        expect_the_rule(surface, resolved);
        LinkedSurface divided = surface;
        exchanges += find_vertex_fans(divided, resolved).count - find_vertex_fans(surface, {}).count;
    }
    EXPECT_GT(exchanges, 1'000u);
}

TEST(FindFans, TakesStepsInProportionToAnEdgeThatManyShare)
{
    // Sixteen times the leaves: twice the logarithm squared at most, where a step for each pair would make it 256.
    constexpr std::uint32_t kFew = 1'000, kMany = 16 * kFew;
    constexpr std::uint64_t kMostGrowth = 32;
    const auto steps = [](std::uint32_t k, bool together) {
        std::mt19937 random(3);
        std::vector<std::uint32_t> next = cycle(k, random);
        if (!together) std::iota(next.begin(), next.end(), 0u);
        NonmanifoldEdge edge;
        LinkedSurface surface = leaves(next, edge);
        return find_vertex_fans(surface, std::span(&edge, 1)).steps;
    };
    for (const bool together : {false, true}) {
        EXPECT_GT(steps(kFew, together), kFew);
        EXPECT_LE(steps(kMany, together), kMostGrowth * steps(kFew, together));
    }
}

}  // namespace
}  // namespace kerf::core
