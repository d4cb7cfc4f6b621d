#include "common/caps/topological_triangulator.h"

#include "common/caps/halve_loop.h"

namespace kerf::core {

namespace {

class TopologicalTriangulator final : public CapTriangulator
{
public:
    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        cap.clear();
        for (std::size_t loop = 0; loop + 1 < outline.loop_starts.size(); ++loop) {
            reduce(outline, outline.loop_starts[loop], outline.loop_starts[loop + 1], cap);
            if (ring_.size() >= 3) halver_.halve(outline.positions, ring_, cap.triangles);
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
    LoopHalver halver_;
};

}  // namespace

std::unique_ptr<CapTriangulator> make_topological_triangulator()
{
    return std::make_unique<TopologicalTriangulator>();
}

}  // namespace kerf::core
