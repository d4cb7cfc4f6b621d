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

}  // namespace

std::optional<TakenApart> take_apart(const SolidOfPoints& solid, std::span<const glm::dvec3> sites, double least_volume)
{
    Box box;
    for (const glm::vec3& p : solid.points) box.add(p);
    const glm::dvec3 size = glm::dvec3(box.hi) - glm::dvec3(box.lo);
    const double diagonal = glm::length(size), none = kLeastShare * (size.x * size.y * size.z);

    TakenApart apart;
    apart.sites.assign(sites.begin(), sites.end());
    double distance = kFirstMove * diagonal;
    for (int move = 0; move <= kMostMoves; ++move, distance *= 2.0) {
        if (move > 0) apart.sites = moved_a_little(sites, distance, static_cast<std::uint64_t>(move));
        auto split = split_into_cells(solid.points, solid.triangles, apart.sites);
        if (!split) continue;
        apart.split = *std::move(split);
        apart.fragments = find_fragments(solid.points, apart.split, std::max(least_volume, none));
        return apart;
    }
    return std::nullopt;
}

}  // namespace kerf::core
