#pragma once

#include <span>
#include <vector>

#include "common/caps/cap_triangulator.h"

namespace kerf::core {

/// Triangulates one loop by its order alone. Keeps its memory.
class LoopHalver
{
public:
    /// `ring` holds the points' numbers; edge i of `ring` runs from ring[i] to its successor and is the outline's edge
    /// ring[i]. Equal positions are never joined by a diagonal, so no triangle has two corners at one place: `ring` must
    /// have no two consecutive edges that run forth and back. Appends to `triangles`.
    void halve(std::span<const glm::vec3> positions, std::span<const Index> ring, std::vector<CapTriangle>& triangles);

private:
    struct Span
    {
        Index first, last;  ///< positions in the ring
        CapLink link;       ///< what lies across the edge last -> first
    };

    std::vector<Span> spans_;
};

}  // namespace kerf::core
