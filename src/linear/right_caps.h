#pragma once

#include <vector>

#include "common/caps/section_closer.h"
#include "linear/closing.h"

namespace kerf::core::linear {

/// Closes sections of any shape, as the half-edge back end does: common/caps/section_closer.h. O(k log k) for k outline
/// edges; if the section passes a point twice or touches what was there before, O(n) more.
class RightCaps final : public Closing
{
public:
    ClosedSides close(BySide<SideBuilder>& builders, Crossings& crossings, const LinkedSection& linked) override;
    void finish(Fragment& fragment, const Plane& plane) override;

private:
    void collect_loops(const LinkedSection& linked);
    void append_caps(SideBuilder& builder, Crossings& crossings, const LinkedSection& linked,
                     std::vector<std::uint32_t>& path_of_cap);
    /// Unites points of a side that caps join.
    void unite_points(SideBuilder& builder, std::uint32_t first_vertex) const;
    /// Whether the points of the sides are as IndexedMesh promises without more ado.
    bool is_regular(const Crossings& crossings, const LinkedSection& linked) const;

    SectionCloser closer_;
    SectionCaps caps_;
    std::vector<CapLoop> loops_;
    std::vector<std::uint32_t> path_of_set_;  ///< one of its paths
    std::vector<glm::vec3> points_;           ///< of the loops, and behind them where loops cross
    std::vector<std::uint32_t> edge_at_;      ///< of each of them the section edge that starts there, or one near by
    std::vector<Index> next_;                 ///< of each point of a loop
    bool is_regular_ = true;
};

}  // namespace kerf::core::linear
