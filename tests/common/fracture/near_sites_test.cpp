#include "common/fracture/near_sites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "common/support/random.h"

namespace kerf::core {
namespace {

/// So many sites, spread as `place` says.
template <class Spread>
std::vector<glm::dvec3> sites_of(std::size_t count, Spread place)
{
    Random random(count);
    std::vector<glm::dvec3> sites;
    for (std::size_t i = 0; i < count; ++i) sites.push_back(place(random));
    return sites;
}

/// All others, sorted by distance and number.
std::vector<std::pair<double, std::uint32_t>> sorted_around(std::span<const glm::dvec3> sites, std::uint32_t site)
{
    std::vector<std::pair<double, std::uint32_t>> all;
    for (std::uint32_t i = 0; i < sites.size(); ++i) {
        const glm::dvec3 away = sites[i] - sites[site];
        if (i != site) all.emplace_back(glm::dot(away, away), i);
    }
    std::ranges::sort(all);
    return all;
}

void expect_sorted(const std::vector<glm::dvec3>& sites)
{
    NearSites near(sites);
    for (std::uint32_t site = 0; site < sites.size(); site += 1 + std::uint32_t(sites.size()) / 50) {
        near.around(site);
        std::vector<std::pair<double, std::uint32_t>> found;
        for (std::pair<double, std::uint32_t> next; near.next(next);) found.push_back(next);
        ASSERT_EQ(found, sorted_around(sites, site)) << "around " << site << " of " << sites.size();
    }
}

glm::dvec3 anywhere(Random& random)
{
    const double x = random.unit(), y = random.unit(), z = random.unit();
    return {x, y, z};
}

}  // namespace

TEST(NearSites, AreAllOthersTheNearestFirst)
{
    for (const std::size_t count : {1u, 2u, 3u, 10u, 100u, 1000u, 3000u}) expect_sorted(sites_of(count, anywhere));
}

TEST(NearSites, HoweverTheyLie)
{
    const auto flat = [](Random& r) { return anywhere(r) * glm::dvec3(1, 1, 0); };
    const auto in_line = [](Random& r) { return anywhere(r) * glm::dvec3(0, 1, 0) + 5.0; };
    const auto clustered = [](Random& r) {
        const glm::dvec3 p = anywhere(r);
        return p * p * p * p * p * 100.0;
    };
    const auto on_a_lattice = [](Random& r) { return glm::floor(anywhere(r) * 5.0); };
    const auto at_one_place = [](Random&) { return glm::dvec3(3, 2, 1); };
    const auto far_apart = [](Random& r) { return (anywhere(r) - 0.5) * 1e308; };
    expect_sorted(sites_of(500, flat));
    expect_sorted(sites_of(500, in_line));
    expect_sorted(sites_of(500, clustered));
    expect_sorted(sites_of(500, on_a_lattice));
    expect_sorted(sites_of(200, at_one_place));
    expect_sorted(sites_of(200, far_apart));
}

TEST(NearSites, OfNoneThereIsNothingToAsk)
{
    const NearSites none({});
}

}  // namespace kerf::core
