#include "common/caps/clipping_triangulator.h"

#include "common/caps/ear_clipper.h"

namespace kerf::core {

namespace {

class ClippingTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        cap.clear();
        const std::size_t n = outline.points.size(), most = kMostLooks * (n + kFewPoints);
        if (outline.loop_starts.size() != 2 || n < 3) return false;
        Ring& ring = clipper_.ring();
        ring.resize(n);
        for (Index i = 0; i < n; ++i) {
            ring.points[i] = outline.points[i];
            ring.numbers[i] = i;
            ring.edges[i] = CapLink::to_outline(i);
        }
        std::uint64_t looks_left = most;
        const bool closed = clipper_.clip_in_layers(cap, looks_left);
        cap.steps += most - looks_left;
        return closed;
    }

private:
    /// Limit of reflex corners looked at, for each point of the loop, before it is given up: teeth that lean over one
    /// another lie in the bounds of many ears.
    static constexpr std::size_t kMostLooks = 256, kFewPoints = 1024;

    EarClipper clipper_;
};

}  // namespace

std::unique_ptr<CapTriangulator> make_clipping_triangulator()
{
    return std::make_unique<ClippingTriangulator>();
}

}  // namespace kerf::core
