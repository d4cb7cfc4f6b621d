#include "common/caps/near_places.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "support/fixtures.h"

namespace kerf::core {
namespace {

using test::Random;

constexpr double kRadius = 1e-3;

/// Some anywhere, some in crowds, some a radius apart to the bit.
std::vector<glm::dvec2> some_places(Random& random)
{
    std::vector<glm::dvec2> places;
    const std::uint32_t count = 1 + random.below(200);
    while (places.size() < count) {
        glm::dvec2 p(random.uniform(), random.uniform());
        if (!places.empty() && random.below(2) == 0)
            p = places[random.below(static_cast<std::uint32_t>(places.size()))] +
                3.0 * kRadius * glm::dvec2(random.uniform() - 0.5, random.uniform() - 0.5);
        if (!places.empty() && random.below(8) == 0) p = places.back() + glm::dvec2(kRadius, 0.0);
        places.push_back(p);
    }
    return places;
}

std::vector<Index> in_order(std::size_t count)
{
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), Index{0});
    return order;
}

bool are_near(const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 apart = glm::abs(a - b);
    return apart.x <= kRadius && apart.y <= kRadius;
}

TEST(NearPlaces, ThatStandForOthersAreFarFromOneAnotherAndNearThem)
{
    Random random(1);
    for (int run = 0; run < 200; ++run) {
        const std::vector<glm::dvec2> places = some_places(random);
        const std::vector<Index> standing = stand_ins(places, in_order(places.size()), kRadius);
        for (Index i = 0; i < places.size(); ++i) {
            EXPECT_TRUE(are_near(places[i], places[standing[i]]));
            EXPECT_EQ(standing[standing[i]], standing[i]);
            EXPECT_LE(standing[i], i) << "the first in the order stands for what comes later";
            for (Index j = 0; j < i; ++j)
                if (standing[i] == i && standing[j] == j) {
                    EXPECT_FALSE(are_near(places[i], places[j]));
                }
        }
    }
}

TEST(NearPlaces, BesideAnEdgeAreThoseWithinTheRadiusInTheirOrder)
{
    Random random(2);
    for (int run = 0; run < 200; ++run) {
        const std::vector<glm::dvec2> places = some_places(random);
        std::vector<Index> which = in_order(places.size());
        std::erase_if(which, [&](Index) { return random.below(4) == 0; });
        PlaceTree tree;
        tree.build(places, which);
        for (int edge = 0; edge < 20; ++edge) {
            glm::dvec2 a(random.uniform(), random.uniform()), b(random.uniform(), random.uniform());
            if (edge % 3 == 0) b.x = a.x;
            if (edge % 3 == 1) a = places[random.below(static_cast<std::uint32_t>(places.size()))];
            std::vector<Index> found, expected;
            std::uint64_t looks = 0;
            tree.append_beside(a, b, kRadius, found, looks);
            const glm::dvec2 direction = (b - a) / glm::distance(a, b);
            const auto along = [&](Index i) { return glm::dot(places[i] - a, direction); };
            for (const Index i : which) {
                const glm::dvec2 offset = places[i] - a;
                const double beside = std::abs(offset.x * direction.y - offset.y * direction.x);
                if (beside <= kRadius && along(i) > 0.0 && along(i) < glm::distance(a, b)) expected.push_back(i);
            }
            EXPECT_TRUE(std::is_sorted(found.begin(), found.end(),
                                       [&](Index i, Index j) { return along(i) < along(j) - 1e-15; }));
            EXPECT_LE(looks, which.size());
            std::sort(found.begin(), found.end());
            EXPECT_EQ(found, expected);
        }
    }
}

TEST(NearPlaces, AreFoundWithoutLookingAtAllOfThem)
{
    Random random(3);
    std::vector<glm::dvec2> places(100'000);
    for (glm::dvec2& p : places) p = {random.uniform(), random.uniform()};
    PlaceTree tree;
    tree.build(places, in_order(places.size()));
    std::uint64_t looks = 0;
    std::vector<Index> found;
    for (int edge = 0; edge < 100; ++edge)
        tree.append_beside({random.uniform(), random.uniform()}, {random.uniform(), random.uniform()}, 1e-9, found,
                           looks);
    EXPECT_LT(looks, 100 * 4000u);
}

}  // namespace
}  // namespace kerf::core
