#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/repair/shells.h"

namespace kerf::core {

/// Which shells make up which solid, and which shells are inside out.
struct Solids
{
    std::vector<std::uint32_t> solid;  ///< for each shell; dense, in the order of the solids' first shells
    std::vector<std::uint8_t> flip;    ///< for each shell whether to turn it over
};

/// Groups shells into solids. A closed shell lies in another if a point of its inside does (majority of three). An
/// outermost shell of negative volume is inside out and is flipped together with everything in it. A solid is a shell
/// that is not a cavity, together with its cavities: closed shells of negative or practically no volume, each of which
/// belongs to the smallest shell of positive volume around it. Every open shell is a solid of its own. O(n log n) for n
/// triangles if most shells with nested boxes are nested.
Solids find_solids(const LinkedSurface& surface, const Shells& shells, std::span<const glm::vec3> positions);

}  // namespace kerf::core
