#include "common/caps/halve_loop.h"

namespace kerf::core {

namespace {

/// The point of a ring nearest to the middle between two whose position differs from those of both.
Index middle_of(std::span<const glm::vec3> positions, std::span<const Index> ring, Index first, Index last)
{
    const Index middle = first + (last - first) / 2;
    const auto same = [&](Index a, Index b) { return positions[ring[a]] == positions[ring[b]]; };
    const auto usable = [&](Index m) { return m > first && m < last && !same(m, first) && !same(m, last); };
    for (Index d = 0; d <= last - first; ++d) {
        if (usable(middle + d)) return middle + d;
        if (middle >= first + d && usable(middle - d)) return middle - d;
    }
    return middle;
}

}  // namespace

void LoopHalver::halve(std::span<const glm::vec3> positions, std::span<const Index> ring,
                       std::vector<CapTriangle>& triangles)
{
    spans_.clear();
    // The edge from the last point to the first belongs to the outline: it closes the outermost triangle.
    spans_.push_back({0, static_cast<Index>(ring.size() - 1), CapLink::to_outline(ring.back())});
    while (!spans_.empty()) {
        const auto [first, last, link] = spans_.back();
        spans_.pop_back();
        const Index middle = middle_of(positions, ring, first, last);
        const Index t = static_cast<Index>(triangles.size());
        triangles.push_back({{ring[first], ring[middle], ring[last]}});
        connect(triangles, CapLink::to_triangle(t, 2), link);
        // Edge 0 runs from first to middle, edge 1 from middle to last.
        for (Index edge = 0; edge < 2; ++edge) {
            const Index a = edge == 0 ? first : middle, b = edge == 0 ? middle : last;
            if (b == a + 1)
                triangles[t].link[edge] = CapLink::to_outline(ring[a]);
            else
                spans_.push_back({a, b, CapLink::to_triangle(t, edge)});
        }
    }
}

}  // namespace kerf::core
