#include "common/caps/nested_triangulator.h"

#include <cstdint>

#include "common/caps/ear_clipper.h"
#include "common/caps/hole_bridges.h"

namespace kerf::core {
namespace {

struct Limit
{
    std::uint64_t looks, looks_for_each_point;  ///< at corners
    bool takes_any_loop;
};

constexpr Limit kBySize{std::uint64_t{1} << 18, 256, false};
constexpr Limit kSomeSeconds{std::uint64_t{1} << 27, 0, true};

class NestedTriangulator final : public CapTriangulator
{
public:
    explicit NestedTriangulator(const Limit& limit) : limit_(limit) {}

    bool triangulate(const CapOutline& outline, CapMesh& cap) override
    {
        cap.clear();
        if (outline.points.size() < 3) return false;
        const std::uint64_t most = limit_.looks + limit_.looks_for_each_point * outline.points.size();
        std::uint64_t looks_left = most;
        const bool closed =
            bridger_.build(outline, rings_, looks_left) && is_worth_it() && clip_rings(outline, cap, looks_left);
        cap.steps += most - looks_left;
        return closed;
    }

private:
    /// One ring of one loop that is as it was: its ears are few, and others close it sooner.
    bool is_worth_it() const
    {
        return limit_.takes_any_loop || rings_.bridge_count > 0 || rings_.starts.size() > 2 || !rings_.shared.empty();
    }

    bool clip_rings(const CapOutline& outline, CapMesh& cap, std::uint64_t& looks_left)
    {
        for (std::size_t ring = 0; ring + 1 < rings_.starts.size(); ++ring) {
            fill_in(outline, rings_.starts[ring], rings_.starts[ring + 1]);
            if (!clipper_.clip_with_patience(cap, looks_left)) return false;
        }
        bridger_.join_triangles(outline, rings_, cap);
        cap.shared_points = rings_.shared;
        return true;
    }

    void fill_in(const CapOutline& outline, Index first, Index last)
    {
        Ring& ring = clipper_.ring();
        ring.resize(last - first);
        for (Index i = first; i < last; ++i) {
            ring.points[i - first] = outline.points[rings_.points[i]];
            ring.numbers[i - first] = rings_.points[i];
            ring.edges[i - first] = rings_.links[i];
        }
    }

    const Limit& limit_;
    HoleBridger bridger_;
    Rings rings_;
    EarClipper clipper_;
};

}  // namespace

std::unique_ptr<CapTriangulator> make_nested_triangulator()
{
    return std::make_unique<NestedTriangulator>(kBySize);
}

std::unique_ptr<CapTriangulator> make_patient_triangulator()
{
    return std::make_unique<NestedTriangulator>(kSomeSeconds);
}

}  // namespace kerf::core
