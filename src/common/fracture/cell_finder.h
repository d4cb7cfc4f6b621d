#pragma once

#include <cstdint>
#include <glm/vec3.hpp>

#include "common/fracture/cell_diagram.h"
#include "common/mesh/box.h"

namespace kerf::core {

/// The number that decides which cell a point lies in, rounded: what all decisions start from.
inline double squared_distance_to_site(const glm::vec3& point, const glm::dvec3& site)
{
    const glm::dvec3 away = glm::dvec3(point) - site;
    return (away.x * away.x + away.y * away.y) + away.z * away.z;
}

/// Finds the cells that places lie in, from that of the last one on: from cell to cell, as long as a neighbour is nearer.
/// So places that follow one another should lie close together.
class CellFinder
{
public:
    /// The diagram stays as it is meanwhile.
    explicit CellFinder(const CellDiagram& diagram) : diagram_(diagram) {}

    /// The cell of a point, by rounded distances; of two that are equally near the first.
    std::uint32_t cell_of(const glm::vec3& point);
    /// The cell that each point of a box lies in, for any rounding, or kNone: then the box may lie in several.
    std::uint32_t cell_of(const Box& box);

private:
    const CellDiagram& diagram_;
    std::uint32_t cell_ = 0;
};

}  // namespace kerf::core
