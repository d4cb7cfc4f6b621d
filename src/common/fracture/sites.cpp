#include "common/fracture/sites.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "common/fracture/grid_layers.h"
#include "common/fracture/inside_points.h"
#include "common/mesh/box.h"

namespace kerf::core {

namespace {

/// Shares of the diagonal of the box: how far from a point or a plane cells are half as dense as they are there, or less.
constexpr double kImpactReach = 0.12, kCrackReach = 0.05;
/// Points that are looked at for each site of an impact or a crack.
constexpr std::size_t kCandidates = 24;
/// Share of their distance by which sites of a grid are moved.
constexpr double kJitter = 0.45;
/// Share of the sites' distance by which splinters begin and end before or behind one another.
constexpr double kUneven = 0.8;
/// Of two splinters, as a share of their usual distance.
constexpr double kLeastApart = 0.01;

class SiteMaker
{
public:
    SiteMaker(const TriangleSearch& triangles, const SitesWanted& wanted)
        : wanted_(wanted),
          random_(Random::mix(wanted.seed) ^ static_cast<std::uint64_t>(wanted.pattern)),
          sample_(triangles, lines_for(wanted), random_),
          box_(triangles.bounds())
    {
        diagonal_ = glm::length(glm::dvec3(box_.hi) - glm::dvec3(box_.lo));
    }

    std::vector<glm::dvec3> make()
    {
        if (sample_.is_empty() || wanted_.count == 0) return {};
        switch (wanted_.pattern) {
            case FracturePattern::uniform:
                while (sites_.size() < wanted_.count) sites_.push_back(sample_.point(random_));
                break;
            case FracturePattern::impact:
                choose([&](const glm::dvec3& p) { return density(glm::length(p - wanted_.at), kImpactReach); });
                break;
            case FracturePattern::crack:
                choose([&](const glm::dvec3& p) {
                    return density(glm::dot(p - wanted_.at, wanted_.direction), kCrackReach);
                });
                break;
            case FracturePattern::grid:
                make_grid();
                break;
            case FracturePattern::splinters:
                make_splinters();
                break;
        }
        std::ranges::sort(sites_, less);
        sites_.erase(std::unique(sites_.begin(), sites_.end()), sites_.end());
        return std::move(sites_);
    }

private:
    static std::size_t lines_for(const SitesWanted& wanted)
    {
        const bool chooses = wanted.pattern == FracturePattern::impact || wanted.pattern == FracturePattern::crack;
        return std::max<std::size_t>(256, wanted.count * (chooses ? kCandidates : 4));
    }

    static bool less(const glm::dvec3& a, const glm::dvec3& b)
    {
        if (a.x != b.x) return a.x < b.x;
        return a.y != b.y ? a.y < b.y : a.z < b.z;
    }

    /// 1 at the place itself, and falling with the fourth power of the distance far away.
    double density(double distance, double reach) const
    {
        const double d = distance / (reach * diagonal_), square = 1.0 + d * d;
        return 1.0 / (square * square);
    }

    /// Takes points by chance, each as likely as its density says.
    template <class Density>
    void choose(Density density_at)
    {
        std::vector<glm::dvec3> candidates;
        for (std::size_t i = 0; i < kCandidates * wanted_.count; ++i) candidates.push_back(sample_.point(random_));
        // Far from the place few are taken: then it's the turn of all others again.
        constexpr int kMostRounds = 64;
        for (int round = 0; round < kMostRounds && sites_.size() < wanted_.count; ++round)
            std::erase_if(candidates, [&](const glm::dvec3& p) {
                if (sites_.size() >= wanted_.count || random_.unit() >= density_at(p)) return false;
                sites_.push_back(p);
                return true;
            });
        for (std::size_t i = 0; i < candidates.size() && sites_.size() < wanted_.count; ++i)
            sites_.push_back(candidates[i]);
    }

    double jitter(double most) { return (random_.unit() - 0.5) * most; }

    void make_grid()
    {
        const glm::dvec3 size = glm::dvec3(box_.hi) - glm::dvec3(box_.lo);
        const Layers count = layers_for(box_, sample_, wanted_.count);
        const glm::dvec3 apart{size.x / double(count[0]), size.y / double(count[1]), size.z / double(count[2])};
        for (std::uint32_t z = 0; z < count[2]; ++z)
            for (std::uint32_t y = 0; y < count[1]; ++y)
                for (std::uint32_t x = 0; x < count[0]; ++x) {
                    const glm::dvec3 middle{double(x) + 0.5, double(y) + 0.5, double(z) + 0.5};
                    const glm::dvec3 moved{jitter(kJitter), jitter(kJitter), jitter(kJitter)};
                    sites_.push_back(glm::dvec3(box_.lo) + (middle + moved) * apart);
                }
    }

    /// In a plane across the grain: borders between sites there run along it.
    void make_splinters()
    {
        std::vector<glm::dvec3> feet;  // on the plane, of points of the object
        std::vector<double> points;    // how high above the plane these are
        // Points come from lines, which may run along the grain: each line is good for one splinter.
        const double least = kLeastApart * size_across() / std::sqrt(double(wanted_.count));
        const auto is_near = [&](const glm::dvec3& foot) {
            return std::ranges::any_of(
                feet, [&](const glm::dvec3& other) { return glm::dot(foot - other, foot - other) < least * least; });
        };
        constexpr std::size_t kTries = 20;  // a site, until another one is near it
        for (std::size_t i = 0; i < kTries * wanted_.count && feet.size() < wanted_.count; ++i) {
            const glm::dvec3 p = sample_.point(random_);
            const double height = glm::dot(p - wanted_.at, wanted_.direction);
            const glm::dvec3 foot = foot_of(p);
            if (is_near(foot)) continue;
            feet.push_back(foot);
            points.push_back(height);
        }
        Box box;
        for (const glm::dvec3& p : feet) box.add(glm::vec3(p));
        const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
        const double apart = glm::length(size) / std::sqrt(double(wanted_.count));
        std::vector<double> sites;
        for (std::size_t i = 0; i < feet.size(); ++i) sites.push_back(jitter(kUneven * apart));
        level(feet, points, sites);
        for (std::size_t i = 0; i < feet.size(); ++i) sites_.push_back(feet[i] + sites[i] * wanted_.direction);
    }

    /// The point's foot on the plane across the grain.
    glm::dvec3 foot_of(const glm::dvec3& point) const
    {
        return point - glm::dot(point - wanted_.at, wanted_.direction) * wanted_.direction;
    }

    /// How large the object is across the grain, as some points tell.
    double size_across()
    {
        constexpr int kPoints = 256;
        Box box;
        for (int i = 0; i < kPoints; ++i) box.add(glm::vec3(foot_of(sample_.point(random_))));
        return glm::length(glm::dvec3(box.hi) - glm::dvec3(box.lo));
    }

    /// Lowers sites until each cell holds the point of the object that its site comes from: borders lean where the sites at
    /// both sides differ in height, and a cell that leans too far would miss a pointed object. O(n^2) for n sites.
    /// @param feet    on the plane
    /// @param points  how high above the plane the object's points are
    /// @param sites   how high the sites are
    static void level(const std::vector<glm::dvec3>& feet, const std::vector<double>& points,
                      std::vector<double>& sites)
    {
        constexpr int kMostRounds = 32;
        constexpr std::size_t kMostUneven = 2000;  // more are thin enough, and would take seconds
        for (int round = 0; round < kMostRounds && feet.size() <= kMostUneven; ++round) {
            std::vector<bool> leans(feet.size(), false);
            bool any = false;
            for (std::size_t i = 0; i < feet.size(); ++i)
                for (std::size_t j = 0; j < feet.size(); ++j) {
                    const glm::dvec3 between = feet[j] - feet[i];
                    if ((sites[j] - sites[i]) * (2.0 * points[i] - sites[i] - sites[j]) <= glm::dot(between, between))
                        continue;
                    leans[i] = leans[j] = any = true;
                }
            if (!any) return;
            for (std::size_t i = 0; i < sites.size(); ++i)
                if (leans[i]) sites[i] *= 0.5;
        }
        std::ranges::fill(sites, 0.0);
    }

    const SitesWanted& wanted_;
    Random random_;
    InsideSample sample_;
    Box box_;
    double diagonal_ = 0.0;
    std::vector<glm::dvec3> sites_;
};

}  // namespace

std::vector<glm::dvec3> make_sites(const TriangleSearch& triangles, const SitesWanted& wanted)
{
    return SiteMaker(triangles, wanted).make();
}

std::vector<glm::dvec3> moved_a_little(std::span<const glm::dvec3> sites, double distance, std::uint64_t seed)
{
    Random random(seed);
    const auto move = [&] { return (random.unit() - 0.5) * 2.0 * distance; };
    std::vector<glm::dvec3> moved;
    for (const glm::dvec3& site : sites) moved.push_back(site + glm::dvec3{move(), move(), move()});
    return moved;
}

}  // namespace kerf::core
