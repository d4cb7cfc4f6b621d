#include "common/caps/halving_triangulator.h"

#include "common/geometry/turn.h"

namespace kerf {

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

/// All turns are left turns and the loop winds around once: the edges' direction passes upward only once.
bool strictly_convex(std::span<const glm::dvec2> p)
{
    const std::size_t n = p.size();
    if (n < 3) return false;
    std::uint32_t turns_up = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const glm::dvec2 &a = p[i], &b = p[i + 1 < n ? i + 1 : 0], &c = p[i + 2 < n ? i + 2 : i + 2 - n];
        if (!(turn(a, b, c) > 0.0)) return false;
        if (b.y < a.y && c.y >= b.y) ++turns_up;
    }
    return turns_up == 1;
}

class ConvexTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        if (outline.loop_starts.size() != 2 || !strictly_convex(outline.points)) return false;
        cap.clear();
        ring_.resize(outline.points.size());
        for (Index i = 0; i < ring_.size(); ++i) ring_[i] = i;
        halve_loop(outline.positions, ring_, cap.triangles);
        return true;
    }

private:
    std::vector<Index> ring_;
};

class TopologicalTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        cap.clear();
        for (std::size_t loop = 0; loop + 1 < outline.loop_starts.size(); ++loop) {
            reduce(outline, outline.loop_starts[loop], outline.loop_starts[loop + 1], cap);
            if (ring_.size() >= 3) halve_loop(outline.positions, ring_, cap.triangles);
        }
        return true;
    }

private:
    /// Drops edges that run forth and straight back; `ring_` is the rest of the loop.
    void reduce(const CapOutline& outline, Index first, Index last, CapMesh& cap)
    {
        const auto at = [&](Index i) -> const glm::vec3& { return outline.positions[i]; };
        ring_.clear();
        // ring_[i] stands for the edge from ring_[i] to ring_[i + 1]; the last one still waits for its end.
        for (Index i = first; i < last; ++i) {
            ring_.push_back(i);
            fold(at, cap);
        }
        // Across the joint: the edges before and after the first point.
        for (;;) {
            const std::size_t n = ring_.size();
            if (n >= 2 && at(ring_[n - 1]) == at(ring_[1])) {
                cap.cancelled.push_back({ring_.back(), ring_.front()});
                ring_.pop_back();
                ring_.erase(ring_.begin());
            } else if (n >= 2 && at(ring_[n - 2]) == at(ring_[0])) {
                cap.cancelled.push_back({ring_[n - 2], ring_[n - 1]});
                ring_.erase(ring_.end() - 2, ring_.end());
            } else {
                return;
            }
        }
    }

    template <class At>
    void fold(const At& at, CapMesh& cap)
    {
        // a, b, a': the edges a -> b and b -> a' cancel, and the edge that leaves a' goes on in their place.
        while (ring_.size() >= 3 && at(ring_[ring_.size() - 3]) == at(ring_.back())) {
            const Index a = ring_[ring_.size() - 3], b = ring_[ring_.size() - 2], c = ring_.back();
            cap.cancelled.push_back({a, b});
            ring_.erase(ring_.end() - 3, ring_.end());
            ring_.push_back(c);
        }
    }

    std::vector<Index> ring_;
};

}  // namespace

void halve_loop(std::span<const glm::vec3> positions, std::span<const Index> ring, std::vector<CapTriangle>& triangles)
{
    Halver(positions, ring, triangles).run();
}

std::unique_ptr<CapTriangulator> make_convex_triangulator()
{
    return std::make_unique<ConvexTriangulator>();
}

std::unique_ptr<CapTriangulator> make_topological_triangulator()
{
    return std::make_unique<TopologicalTriangulator>();
}

}  // namespace kerf
