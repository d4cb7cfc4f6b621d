#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace kerf::sim {

/// A part of something that is held together by bonds.
struct LoadedPart
{
    double mass = 0.0;       ///< kg
    glm::dvec3 centre{0.0};  ///< of mass, metres
};

/// Between two parts, by their numbers.
struct LoadedBond
{
    std::uint32_t first = 0, second = 0;
    double strength = 0.0;  ///< the largest impulse that it passes on, N s
};

/// Which bonds a blow breaks. What is struck is a rigid whole, so of an impulse J at a place all that lies farther than any
/// distance from there must be given its share by mass, through the bonds that cross that distance: if the parts nearer
/// weigh m of M, these pass on J (1 - m / M) together. If that is more than all of them hold, they break. Around the place
/// few bonds pass on nearly all, so a weak blow breaks off crumbs, and a strong one goes through.
///
/// @param impulse  its size, N s
/// One flag a bond. O(parts log parts + bonds).
std::vector<bool> broken_bonds(std::span<const LoadedPart> parts, std::span<const LoadedBond> bonds,
                               const glm::dvec3& place, double impulse);

}  // namespace kerf::sim
