#include "common/cutting/section_ends.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

namespace kerf::core {

PlaceInTriangle place_in_triangle(const Plane& plane, std::span<const Vertex> vertices, const Triangle& corners,
                                  const glm::vec3& position)
{
    const auto corner = [&](std::size_t i) -> const glm::vec3& { return vertices[corners[i % 3]].position; };
    for (std::size_t i = 0; i < 3; ++i)
        if (same_position(corner(i), position)) return {corners[i], corners[i], {}};
    const std::array<double, 3> d{plane.signed_distance(corner(0)), plane.signed_distance(corner(1)),
                                  plane.signed_distance(corner(2))};
    for (std::size_t i = 0; i < 3; ++i) {
        const double from = d[i], to = d[(i + 1) % 3];
        if (!(from < 0.0 && to > 0.0) && !(from > 0.0 && to < 0.0)) continue;
        const CutPoint cut = cut_edge(corner(i), from, corner(i + 1), to);
        if (same_position(cut.position, position)) return {corners[i], corners[(i + 1) % 3], cut};
    }
    const auto distance = [&](std::uint32_t v) {
        return glm::distance(glm::dvec3(vertices[v].position), glm::dvec3(position));
    };
    const std::uint32_t nearest =
        *std::ranges::min_element(corners, [&](std::uint32_t v, std::uint32_t w) { return distance(v) < distance(w); });
    return {nearest, nearest, {}};
}

}  // namespace kerf::core
