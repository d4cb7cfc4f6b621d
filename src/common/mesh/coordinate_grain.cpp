#include "common/mesh/coordinate_grain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/mesh/float_range.h"

namespace kerf {

double coordinate_grain(const Box& box)
{
    if (box.empty()) return 0.0;
    return unit_in_last_place(box.largest_coordinate());
}

double shortest_edge(std::span<const Vertex> vertices, std::span<const Triangle> triangles)
{
    constexpr double kInfinite = std::numeric_limits<double>::infinity();
    const auto square = [](const glm::dvec3& edge) {
        const double length2 = glm::dot(edge, edge);
        return length2 > 0.0 ? length2 : kInfinite;
    };
    double shortest = kInfinite;
    for (const auto& [a, b, c] : triangles) {
        if (a >= vertices.size() || b >= vertices.size() || c >= vertices.size()) continue;
        const glm::dvec3 p(vertices[a].position), q(vertices[b].position), r(vertices[c].position);
        // One comparison with the least so far: each waits for the one before.
        shortest = std::min(shortest, std::min(square(q - p), std::min(square(r - q), square(p - r))));
    }
    return std::sqrt(shortest);
}

}  // namespace kerf
