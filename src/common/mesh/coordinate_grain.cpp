#include "common/mesh/coordinate_grain.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "common/mesh/float_range.h"

namespace kerf::core {

double coordinate_grain(const Box& box)
{
    if (box.empty()) return 0.0;
    return unit_in_last_place(box.largest_coordinate());
}

double shortest_edge(std::span<const Vertex> vertices, std::span<const Triangle> triangles)
{
    double shortest = std::numeric_limits<double>::infinity();
    // A shorter edge is rare: a branch that is predicted costs less than a minimum that waits for the one before.
    const auto compare = [&](const glm::dvec3& edge) {
        const double square = glm::dot(edge, edge);
        if (square < shortest && square > 0.0) shortest = square;
    };
    for (const auto& [a, b, c] : triangles) {
        if (std::max({a, b, c}) >= vertices.size()) continue;
        const glm::dvec3 p(vertices[a].position), q(vertices[b].position), r(vertices[c].position);
        compare(q - p);
        compare(r - q);
        compare(p - r);
    }
    return std::sqrt(shortest);
}

}  // namespace kerf::core
