#include "common/caps/convex_triangulator.h"

#include "common/caps/halve_loop.h"
#include "common/geometry/turn.h"

namespace kerf::core {

namespace {

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
        halver_.halve(outline.positions, ring_, cap.triangles);
        return true;
    }

private:
    std::vector<Index> ring_;
    LoopHalver halver_;
};

}  // namespace

std::unique_ptr<CapTriangulator> make_convex_triangulator()
{
    return std::make_unique<ConvexTriangulator>();
}

}  // namespace kerf::core
