#include "common/solids.h"

#include <numeric>

namespace kerf {

Solids find_solids(const LinkedSurface&, const Shells& shells, std::span<const glm::vec3>)
{
    Solids solids;
    const std::size_t count = shells.shells.size();
    solids.solid.resize(count);
    std::iota(solids.solid.begin(), solids.solid.end(), 0u);
    solids.flip.assign(count, 0);
    if (count == 1) solids.flip[0] = shells.shells[0].volume6 < 0.0;
    return solids;
}

}  // namespace kerf
