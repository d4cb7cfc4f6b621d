#include "common/caps/halve_loop.h"

namespace kerf::core {

namespace {

class Halver
{
public:
    Halver(std::span<const glm::vec3> points, std::span<const Index> ring, std::vector<CapTriangle>& triangles)
        : points_(points), ring_(ring), triangles_(triangles)
    {
    }

    void run()
    {
        // The edge from the last point to the first belongs to the outline: it closes the outermost triangle.
        struct Span
        {
            Index first, last;  // positions in the ring
            CapLink link;       // what lies across the edge last -> first
        };
        std::vector<Span> spans{{0, static_cast<Index>(ring_.size() - 1), CapLink::to_outline(ring_.back())}};
        while (!spans.empty()) {
            const auto [first, last, link] = spans.back();
            spans.pop_back();
            const Index middle = middle_of(first, last);
            const Index t = static_cast<Index>(triangles_.size());
            triangles_.push_back({{ring_[first], ring_[middle], ring_[last]}});
            connect(triangles_, CapLink::to_triangle(t, 2), link);
            // Edge 0 runs from first to middle, edge 1 from middle to last.
            for (Index edge = 0; edge < 2; ++edge) {
                const Index a = edge == 0 ? first : middle, b = edge == 0 ? middle : last;
                if (b == a + 1)
                    triangles_[t].link[edge] = CapLink::to_outline(ring_[a]);
                else
                    spans.push_back({a, b, CapLink::to_triangle(t, edge)});
            }
        }
    }

private:
    bool same(Index a, Index b) const { return points_[ring_[a]] == points_[ring_[b]]; }

    /// The point nearest to the middle whose position differs from those of both ends.
    Index middle_of(Index first, Index last) const
    {
        const Index middle = first + (last - first) / 2;
        const auto usable = [&](Index m) { return m > first && m < last && !same(m, first) && !same(m, last); };
        for (Index d = 0; d <= last - first; ++d) {
            if (usable(middle + d)) return middle + d;
            if (middle >= first + d && usable(middle - d)) return middle - d;
        }
        return middle;
    }

    std::span<const glm::vec3> points_;
    std::span<const Index> ring_;
    std::vector<CapTriangle>& triangles_;
};

}  // namespace

void halve_loop(std::span<const glm::vec3> positions, std::span<const Index> ring, std::vector<CapTriangle>& triangles)
{
    Halver(positions, ring, triangles).run();
}

}  // namespace kerf::core
