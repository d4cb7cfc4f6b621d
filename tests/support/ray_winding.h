#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "common/mesh/indexed_mesh.h"

namespace kerf::core::test {

/// How often closed surfaces wind around a point: signed crossings of a ray towards larger z, decided by CGAL's exact
/// orientation predicates. Asks nothing of the surfaces but that they are closed: neither that CGAL can store them nor
/// that they keep clear of themselves.
class RayWinding
{
public:
    /// All surfaces together: where they overlap or lie in one another their numbers add up. O(n).
    explicit RayWinding(const std::vector<IndexedMesh>& surfaces);

    /// Empty where the ray meets an edge, or the point lies in a triangle's plane: not for points that are chosen at
    /// random. O(triangles above and below the point).
    std::optional<int> around(const glm::dvec3& point) const;

    const std::vector<std::array<glm::dvec3, 3>>& triangles() const { return triangles_; }

private:
    /// The cell of a place along an axis, within the grid.
    std::size_t cell(double coordinate, int axis) const;
    template <class Visit>
    void for_each_cell(const std::array<glm::dvec3, 3>& triangle, Visit visit) const;

    std::vector<std::array<glm::dvec3, 3>> triangles_;
    glm::dvec2 lo_{0.0}, cells_per_unit_{0.0};
    std::size_t cells_ = 1;             ///< along each axis
    std::vector<std::uint32_t> first_;  ///< of each cell in `in_cell_`, and their number at the end
    std::vector<std::uint32_t> in_cell_;
};

}  // namespace kerf::core::test
