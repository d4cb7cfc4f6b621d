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
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : triangles) {
        if (std::max({a, b, c}) >= vertices.size()) continue;
        const glm::dvec3 p(vertices[a].position), q(vertices[b].position), r(vertices[c].position);
        for (const glm::dvec3& edge : {q - p, r - q, p - r}) {
            const double square = glm::dot(edge, edge);
            if (square > 0.0) shortest = std::min(shortest, square);
        }
    }
    return std::sqrt(shortest);
}

}  // namespace kerf
