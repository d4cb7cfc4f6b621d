#include "viewer/sim/breaking/bond_loads.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

namespace kerf::sim {

std::vector<bool> broken_bonds(std::span<const LoadedPart> parts, std::span<const LoadedBond> bonds,
                               const glm::dvec3& place, double impulse)
{
    const auto square = [&](std::uint32_t part) {
        const glm::dvec3 d = parts[part].centre - place;
        return glm::dot(d, d);
    };
    std::vector<std::uint32_t> order(parts.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return square(a) < square(b); });
    std::vector<std::size_t> rank(parts.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = i;

    // What all bonds hold between the parts up to a rank and those beyond: begun where a bond's nearer part is, ended
    // where its farther one is.
    std::vector<double> begun(parts.size(), 0.0), ended(parts.size(), 0.0);
    for (const LoadedBond& bond : bonds) {
        const auto [near, far] = std::minmax(rank[bond.first], rank[bond.second]);
        begun[near] += bond.strength;
        ended[far] += bond.strength;
    }
    double whole = 0.0;
    for (const LoadedPart& part : parts) whole += part.mass;

    // Up to each rank: how many of the distances before it are overloaded.
    std::vector<std::size_t> overloaded(parts.size() + 1, 0);
    double mass = 0.0, holds = 0.0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        mass += parts[order[i]].mass;
        holds += begun[i] - ended[i];
        const bool breaks = i + 1 < order.size() && impulse * (1.0 - mass / whole) > holds;
        overloaded[i + 1] = overloaded[i] + (breaks ? 1 : 0);
    }
    std::vector<bool> is_broken;
    is_broken.reserve(bonds.size());
    for (const LoadedBond& bond : bonds) {
        const auto [near, far] = std::minmax(rank[bond.first], rank[bond.second]);
        is_broken.push_back(overloaded[far] > overloaded[near]);
    }
    return is_broken;
}

}  // namespace kerf::sim
