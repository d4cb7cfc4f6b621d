#include "common/repair/umbrellas.h"

#include "common/geometry/disjoint_sets.h"

namespace kerf {

std::uint64_t count_umbrella_points(std::uint32_t point_count, std::span<const Triangle> corners, const EdgeRuns& edges)
{
    // Corner i of triangle t is number 3t + i, like the half-edge that starts there.
    DisjointSets umbrellas(static_cast<std::uint32_t>(corners.size() * 3));
    const auto point_at = [&](std::uint32_t corner) { return corners[corner / 3][corner % 3]; };
    edges.for_each([&](std::span<const EdgeRuns::Side> edge) {
        const std::uint32_t first = edge[0].halfedge;
        for (const EdgeRuns::Side& side : edge.subspan(1)) {
            std::uint32_t start = side.halfedge, end = next_halfedge(start);
            if (point_at(start) != point_at(first)) std::swap(start, end);
            umbrellas.unite(first, start);
            umbrellas.unite(next_halfedge(first), end);
        }
    });

    Buffer<std::uint32_t> umbrellas_at(point_count, 0);
    for (std::uint32_t corner = 0; corner < corners.size() * 3; ++corner)
        if (umbrellas.find(corner) == corner) ++umbrellas_at[point_at(corner)];
    return static_cast<std::uint64_t>(
        std::count_if(umbrellas_at.begin(), umbrellas_at.end(), [](std::uint32_t n) { return n > 1; }));
}

}  // namespace kerf
