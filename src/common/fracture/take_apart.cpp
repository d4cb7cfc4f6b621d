#include "common/fracture/take_apart.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "common/mesh/box.h"

namespace kerf::core {

namespace {

/// How far sites are moved at first, as a share of the diagonal of the box, and how often.
constexpr double kFirstMove = 1e-7;
constexpr int kMostMoves = 12;
/// A fragment with a smaller share of the box's volume is none: rounding has made it.
constexpr double kLeastShare = 1e-12;

glm::dvec3 size_of(const Box& box)
{
    return glm::dvec3(box.hi) - glm::dvec3(box.lo);
}

}  // namespace

std::vector<glm::dvec3> sites_that_split(const Box& box, std::span<const glm::dvec3> sites, const SplitTrial& splits,
                                         const ProgressOfStep& progress)
{
    std::vector<glm::dvec3> tried(sites.begin(), sites.end());
    double distance = kFirstMove * glm::length(size_of(box));
    double done = 0.0;  // each further trial is half of what is left: nobody knows how many there will be
    for (int move = 0; move <= kMostMoves; ++move, distance *= 2.0) {
        if (move > 0) tried = moved_a_little(sites, distance, static_cast<std::uint64_t>(move));
        const double next = move == 0 ? 0.8 : 0.5 * (done + 1.0);
        progress.at(done);
        if (splits(tried, progress.part(done, next))) return tried;
        done = next;
    }
    return {};
}

double least_volume_of_fragment(const Box& box)
{
    const glm::dvec3 size = size_of(box);
    return kLeastShare * (size.x * size.y * size.z);
}

std::optional<TakenApart> take_apart(const SolidOfPoints& solid, std::span<const glm::dvec3> sites, double least_volume,
                                     const ProgressOfStep& progress)
{
    const Box box = AllTriangles(solid).bounds();
    TakenApart apart;
    const auto splits = [&](std::span<const glm::dvec3> tried, const ProgressOfStep& part) {
        auto split = split_into_cells(solid.points, solid.triangles, tried, part);
        if (!split) return false;
        apart.split = *std::move(split);
        return true;
    };
    apart.sites = sites_that_split(box, sites, splits, progress);
    if (apart.sites.empty()) return std::nullopt;
    apart.fragments =
        find_fragments(solid.points, apart.split, std::max(least_volume, least_volume_of_fragment(box)), box.centre());
    return apart;
}

}  // namespace kerf::core
