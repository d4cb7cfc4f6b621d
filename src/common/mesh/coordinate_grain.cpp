#include "common/mesh/coordinate_grain.h"

#include <algorithm>

#include "common/mesh/float_range.h"

namespace kerf::core {

double coordinate_grain(const Box& box)
{
    if (box.empty()) return 0.0;
    return unit_in_last_place(box.largest_coordinate());
}

double shortest_edge(std::span<const Vertex> vertices, std::span<const Triangle> triangles)
{
    ShortestEdge shortest;
    for (const auto& [a, b, c] : triangles)
        if (std::max({a, b, c}) < vertices.size())
            shortest.add(vertices[a].position, vertices[b].position, vertices[c].position);
    return shortest.length();
}

}  // namespace kerf::core
